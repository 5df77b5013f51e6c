package org.dronewatch.run;

import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.drone.Drone;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Encounters;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Measurement;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.FalseAlarmSource;
import org.dronewatch.tracking.ContactLook;
import org.dronewatch.world.World;

/**
 * A sensor during a run, with its positioner: when it looks next, where it points, which cues its positioner has
 * received, and which drones its observer has found.
 */
final class ActiveSensor {
    private final String id;
    private final SensorSettings<?> settings;
    private final Sensor sensor;
    private final double rate;
    private final Optional<Positioner> positioner;
    private final Optional<FalseAlarmSource> falseAlarms;
    private long nextIndex;
    private Encounters encounters = Encounters.NONE;

    ActiveSensor(String id, SensorSettings<?> settings) {
        this.id = id;
        this.settings = settings;
        this.sensor = settings.create();
        this.rate = settings.rate();
        this.positioner = settings.as(Mounted.class).flatMap(Mounted::createPositioner);
        this.falseAlarms = FalseAlarmSource.of(settings);
    }

    String id() {
        return id;
    }

    SensorSettings<?> settings() {
        return settings;
    }

    boolean tracesRays() {
        return sensor instanceof RaySensor;
    }

    /** From the index, not from the last time: adding up intervals drifts. */
    double nextTime() {
        return nextIndex / rate;
    }

    /** Turns the positioner to where it points at a time, and begins the next look. */
    Look nextLook(long seed, double time) {
        Optional<Pointing> pointing = positioner.map(it -> it.moveTo(time));
        return Look.of(seed, id, nextIndex++, time).withPointing(pointing).withEncounters(encounters);
    }

    /** Looks, on any thread. */
    List<Observation> look(World world, List<Drone> drones, Look look, LookTimes times) {
        long start = System.nanoTime();
        List<Observation> observations = sensor.observe(world, drones, look);
        List<Observation> ofNothing =
                falseAlarms.map(source -> source.observe(world, look)).orElse(List.of());
        times.add(settings.kind(), System.nanoTime() - start);
        if (settings.chance() == Chance.PER_ENCOUNTER) {
            encounters = Encounters.after(look, rate, observations);
        }
        List<Observation> ofDrones = known(world, drones, observations);
        return ofNothing.isEmpty()
                ? ofDrones
                : Stream.concat(ofDrones.stream(), ofNothing.stream()).toList();
    }

    private List<Observation> known(World world, List<Drone> drones, List<Observation> observations) {
        return world.isKnownEverywhere()
                ? observations
                : observations.stream()
                        .map(seen -> isKnown(world, seen, drones) ? seen : seen.asUnknown())
                        .toList();
    }

    private boolean isKnown(World world, Observation seen, List<Drone> drones) {
        return drones.stream()
                .filter(drone -> drone.id().equals(seen.drone()))
                .allMatch(drone -> world.isKnown(settings.position(), drone.origin()));
    }

    /** Passes to its positioner what the sensor saw itself, and what the sensors that cue it detected. */
    void learn(List<ContactLook> looks) {
        positioner.ifPresent(it ->
                looks.forEach(look -> look.measurements().forEach(measured -> learn(it, look.contact(), measured))));
    }

    private void learn(Positioner informed, int contact, Measurement measured) {
        measured.sighting().ifPresent(sighting -> {
            if (measured.sensor().equals(id)) {
                informed.see(contact, sighting, measured.time());
            } else if (measured.isDetected() && informed.isCuedBy(measured.sensor())) {
                informed.cue(contact, sighting, measured.time());
            }
        });
    }
}
