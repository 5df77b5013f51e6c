package org.dronewatch.route.proof;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.fusion.Confirmation;
import org.dronewatch.fusion.ConfirmedLooks;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Encounters;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.World;

/**
 * Replays a schedule of looks with other seeds: only up to the first detection on the route, or the alert, and only
 * those looks that can detect the drone. Each of these looks is that of a run with the same seed. Holds the scratch
 * memory of one thread.
 */
final class SeededFlights {
    private final LookSchedule schedule;
    private final World world;
    private final Sensor[] sensors;
    private final Encounters[] encounters;

    SeededFlights(LookSchedule schedule, World world) {
        this.schedule = schedule;
        this.world = world;
        this.sensors = schedule.sensors().stream().map(one -> one.create()).toArray(Sensor[]::new);
        this.encounters = new Encounters[sensors.length];
    }

    /**
     * The run with this seed, up to its first detection.
     *
     * @param alerts if given, how an alert by any single sensor is confirmed; the run then goes on up to its alert
     */
    FlownRun fly(long seed, Optional<Confirmation> alerts) {
        Arrays.fill(encounters, Encounters.NONE);
        List<ConfirmedLooks> confirmed = schedule.sensors().stream()
                .map(sensor -> new ConfirmedLooks(alerts.orElse(Confirmation.DEFAULT)))
                .toList();
        Optional<Observation> first = Optional.empty();
        for (ScheduledLook scheduled : schedule.looks()) {
            Optional<Observation> seen = scheduled.mayDetect() ? detection(scheduled, seed) : Optional.empty();
            if (scheduled.counts()) {
                first = first.or(() -> seen);
                boolean isAlert = confirmed.get(scheduled.number()).add(seen.isPresent()) && alerts.isPresent();
                if (isAlert || first.isPresent() && alerts.isEmpty()) {
                    return new FlownRun(first, isAlert ? OptionalDouble.of(scheduled.time()) : OptionalDouble.empty());
                }
            }
        }
        return new FlownRun(first, OptionalDouble.empty());
    }

    private Optional<Observation> detection(ScheduledLook scheduled, long seed) {
        int number = scheduled.number();
        SensorSettings<?> settings = schedule.sensors().get(number);
        Look own = scheduled.look();
        Look look = Look.of(seed, own.sensor(), own.index(), own.time())
                .withPointing(own.pointing())
                .withEncounters(encounters[number]);
        if (settings.chance() == Chance.PER_LOOK) {
            return detection(sensors[number].observe(world, List.of(scheduled.drone()), look));
        }
        double threshold = look.observerThreshold(scheduled.drone().id(), settings.rate(), scheduled.probability());
        Observation seen = MissedLooks.observation(scheduled, threshold, settings);
        encounters[number] = Encounters.after(look, settings.rate(), List.of(seen));
        return detection(List.of(seen));
    }

    /** The first of these that detects a drone. */
    static Optional<Observation> detection(List<Observation> observations) {
        return observations.stream()
                .filter(one -> one.isDetected() && !one.isFalse())
                .findFirst();
    }
}
