package org.dronewatch.run;

import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.fusion.Alert;
import org.dronewatch.fusion.AlertLog;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Measurement;
import org.dronewatch.tracking.ContactLook;

/**
 * Passes the looks at contacts to all that act on them during a run: the positioners, which their own sensors inform
 * and other sensors cue, and the alert rule. It holds nothing from which the truth can be reached.
 */
final class ContactDispatch {
    private final Map<String, Positioner> positioners = new HashMap<>();
    private final AlertLog alerts;

    /**
     * A dispatch to an alert rule, without positioners yet.
     *
     * @param alerts alerts of the run
     */
    ContactDispatch(AlertLog alerts) {
        this.alerts = alerts;
    }

    /** Adds the positioner that turns a sensor of this name. */
    void add(String sensor, Positioner positioner) {
        positioners.put(sensor, positioner);
    }

    /**
     * Turns the positioner of a sensor until a time, s, not before that of the previous call.
     *
     * @return where it then points; empty for a sensor on a fixed mount
     */
    Optional<Pointing> moveTo(String sensor, double time) {
        return Optional.ofNullable(positioners.get(sensor)).map(positioner -> positioner.moveTo(time));
    }

    /**
     * Passes on the sensors' looks of one time.
     *
     * @return the alerts that they raise
     */
    List<Alert> pass(List<ContactLook> looks) {
        if (!positioners.isEmpty()) {
            List<ContactLook> shuffled = shuffled(looks);
            positioners.forEach((sensor, positioner) -> shuffled.forEach(look ->
                    look.measurements().forEach(measured -> pass(sensor, positioner, look.contact(), measured))));
        }
        return alerts.add(looks);
    }

    /**
     * The looks, in an order of their contacts that is as good as random, but depends only on the directions in which
     * the contacts were measured. A positioner follows the first of several new contacts, and the looks arrive in an
     * order that depends on the truth: drones before false alarms, in the order of the scene's sensors.
     */
    private static List<ContactLook> shuffled(List<ContactLook> looks) {
        Map<Integer, Long> places = new HashMap<>();
        looks.forEach(look -> look.measurements().forEach(measured -> measured.sighting()
                .ifPresent(sighting -> places.merge(look.contact(), place(sighting.direction()), Math::min))));
        return looks.stream()
                .filter(look -> places.containsKey(look.contact()))
                .sorted(Comparator.comparing(look -> places.get(look.contact())))
                .toList();
    }

    private static long place(Direction direction) {
        return Draws.mix(Double.doubleToLongBits(direction.azimuth()), Double.doubleToLongBits(direction.elevation()));
    }

    private static void pass(String sensor, Positioner positioner, int contact, Measurement measured) {
        measured.sighting().ifPresent(sighting -> {
            if (measured.sensor().equals(sensor)) {
                positioner.see(contact, sighting, measured.time());
            } else if (measured.isDetected() && positioner.isCuedBy(measured.sensor())) {
                positioner.cue(contact, sighting, measured.time());
            }
        });
    }

    /** The alerts of the run. */
    AlertLog alerts() {
        return alerts;
    }
}
