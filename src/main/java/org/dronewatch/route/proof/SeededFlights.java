package org.dronewatch.route.proof;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.dronewatch.run.Frame;
import org.dronewatch.run.ModelCache;
import org.dronewatch.run.RunSession;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Encounters;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.World;

/**
 * Runs of a schedule of looks with other seeds, only up to the first detection on the route, and only those looks that
 * can detect the drone. Each of these is the look of a run with the same seed. Scratch memory of one thread.
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

    /** The look with which a run with this seed first detects the drone; empty if none does. */
    Optional<Observation> firstDetection(long seed) {
        Arrays.fill(encounters, Encounters.NONE);
        return schedule.looks().stream()
                .filter(ScheduledLook::mayDetect)
                .map(scheduled -> detection(scheduled, seed).filter(seen -> scheduled.counts()))
                .flatMap(Optional::stream)
                .findFirst();
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

    private static Optional<Observation> detection(List<Observation> observations) {
        return observations.stream()
                .filter(one -> one.isDetected() && !one.isFalse())
                .findFirst();
    }

    /** The same by a plain run. */
    static Optional<Observation> firstDetectionOfRun(SceneSettings settings, long seed, ModelCache models) {
        try (RunSession session = new RunSession(settings, seed, models)) {
            double begin = RouteScene.begin(settings);
            while (session.nextTime().isPresent()) {
                Frame frame = session.advance();
                Optional<Observation> detection = detection(frame.observations());
                if (detection.isPresent() && frame.time() >= begin) {
                    return detection;
                }
            }
            return Optional.empty();
        }
    }
}
