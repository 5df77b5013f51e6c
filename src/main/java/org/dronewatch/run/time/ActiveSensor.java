package org.dronewatch.run.time;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.drone.Drone;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Encounters;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.alarm.FalseAlarmSource;
import org.dronewatch.world.Weather;
import org.dronewatch.world.World;

/** A sensor during a run: when it looks next, which drones its observer has found, and its false alarms. */
public final class ActiveSensor {
    private final String id;
    private final SensorSettings<?> settings;
    private final Sensor sensor;
    private final double rate;
    private final Optional<FalseAlarmSource> falseAlarms;
    private long nextIndex;
    private Encounters encounters = Encounters.NONE;

    public ActiveSensor(String id, SensorSettings<?> settings, Weather weather) {
        this.id = id;
        this.settings = settings;
        this.sensor = settings.create();
        this.rate = settings.rate();
        this.falseAlarms = FalseAlarmSource.of(settings, weather);
    }

    public String id() {
        return id;
    }

    public SensorSettings<?> settings() {
        return settings;
    }

    public boolean tracesRays() {
        return sensor instanceof RaySensor;
    }

    /** The time of the next look, s, computed from its index: adding up intervals would drift. */
    public double nextTime() {
        return nextIndex / rate;
    }

    /**
     * Begins the next look.
     *
     * @param pointing pointing of the sensor's positioner at the time of the look; empty for a sensor on a fixed mount
     */
    public Look nextLook(long seed, double time, Optional<Pointing> pointing) {
        return Look.of(seed, id, nextIndex++, time).withPointing(pointing).withEncounters(encounters);
    }

    /** Takes a look, on any thread. */
    public List<Observation> look(World world, List<Drone> drones, Look look, LookTimes times) {
        long start = System.nanoTime();
        List<Observation> observations = sensor.observe(world, drones, look);
        List<Observation> ofNothing =
                falseAlarms.map(source -> source.observe(world, look)).orElse(List.of());
        times.add(settings.kind(), System.nanoTime() - start);
        if (settings.chance() == Chance.PER_ENCOUNTER) {
            encounters = Encounters.after(look, rate, observations);
        }
        List<Observation> ofDrones = birds(drones, known(world, drones, observations));
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

    /** Marks what was observed of birds, for scoring. */
    private static List<Observation> birds(List<Drone> drones, List<Observation> observations) {
        Set<String> birds = drones.stream()
                .filter(drone -> drone.settings().isBird())
                .map(Drone::id)
                .collect(Collectors.toSet());
        return birds.isEmpty()
                ? observations
                : observations.stream()
                        .map(seen -> birds.contains(seen.drone()) ? seen.asBird() : seen)
                        .toList();
    }

    private boolean isKnown(World world, Observation seen, List<Drone> drones) {
        return drones.stream()
                .filter(drone -> drone.id().equals(seen.drone()))
                .allMatch(drone -> world.isKnown(settings.position(), drone.origin()));
    }
}
