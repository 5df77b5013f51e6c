package org.dronewatch.route.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.parallel.Workers;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.run.Stage;
import org.dronewatch.run.time.EmissionTime;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.World;

/**
 * All looks that a run takes at its only drone, each assessed exactly where it is taken: at the time, the position, the
 * heading and the speed of the run, and with the pointing of a positioner that only searches. Looks before the route
 * begins, while the drone waits, do not count. Immutable.
 */
final class LookSchedule {
    private final List<SensorSettings<?>> sensors;
    private final List<ScheduledLook> looks;
    private final double begin;

    /**
     * Looks that have been assessed.
     *
     * @param sensors settings of the sensors, in the order of the scene
     * @param looks the looks, in order of time
     * @param begin when the route begins, s since the start of the run
     */
    LookSchedule(List<SensorSettings<?>> sensors, List<ScheduledLook> looks, double begin) {
        this.sensors = List.copyOf(sensors);
        this.looks = List.copyOf(looks);
        this.begin = begin;
    }

    /**
     * Assesses all looks, on the {@link Workers} of the calling thread.
     *
     * @param settings settings of a scene with one drone, {@linkplain RouteScene#withoutCues without cues}
     * @param stage stage of the same scene
     * @param count number of estimates of a look; see {@link LookEstimates#of}
     */
    static LookSchedule of(SceneSettings settings, Stage stage, int count) {
        Drone drone = stage.dronesAt(0.0).get(0);
        FlightPath path = stage.flight(drone.id());
        List<String> names = List.copyOf(settings.enabledSensors().keySet());
        List<SensorSettings<?>> sensors = List.copyOf(settings.enabledSensors().values());
        double begin = RouteScene.begin(settings);
        List<ScheduledLook> taken = new ArrayList<>();
        for (int sensor = 0; sensor < sensors.size(); sensor++) {
            SensorSettings<?> one = sensors.get(sensor);
            Optional<Positioner> positioner = one.as(Mounted.class).flatMap(Mounted::createPositioner);
            double speed = one.signalSpeed(stage.world());
            for (long index = 0; index / one.rate() <= settings.run().duration(); index++) {
                double time = index / one.rate();
                Optional<Pointing> pointing = positioner.map(its -> its.moveTo(time));
                Look look = Look.of(settings.run().seed(), names.get(sensor), index, time)
                        .withPointing(pointing);
                OptionalDouble left = Double.isFinite(speed)
                        ? EmissionTime.of(path, one.position(), speed, time)
                        : OptionalDouble.of(time);
                // Sound that the drone emitted while it waited does not count either.
                boolean counts = left.isPresent() && left.getAsDouble() >= begin;
                // What an observer sees of the drone before decides which encounter follows.
                if (left.isPresent() && (counts || one.chance() == Chance.PER_ENCOUNTER)) {
                    taken.add(new ScheduledLook(
                            sensor, look, drone.at(path.at(left.getAsDouble())), RayEstimate.exact(0.0), counts));
                }
            }
        }
        taken.sort(Comparator.comparingDouble(ScheduledLook::time));
        LookEstimates estimates = new LookEstimates(names, sensors, stage.world());
        return new LookSchedule(sensors, estimates.of(taken, count), begin);
    }

    /**
     * This schedule with more estimates, on the {@link Workers} of the calling thread.
     *
     * @param settings settings of the same scene
     * @param world world of the scene
     * @param counts for each look, the minimum number of estimates
     */
    LookSchedule withEstimates(SceneSettings settings, World world, int[] counts) {
        List<String> names = List.copyOf(settings.enabledSensors().keySet());
        return new LookSchedule(sensors, new LookEstimates(names, sensors, world).more(looks, counts), begin);
    }

    /** When the route begins, s since the start of the run. */
    double begin() {
        return begin;
    }

    /** The looks in order of time. */
    List<ScheduledLook> looks() {
        return looks;
    }

    /** The settings of the sensors, in the order of the scene. */
    List<SensorSettings<?>> sensors() {
        return sensors;
    }

    /**
     * The probability that no sensor has detected the drone on the route by a time: of looks whose chances are
     * independent {@code prod(1 - p)}, and of each encounter with an observer the mean over all draws.
     *
     * @param until s since the start of the run, inclusive
     * @param wait whether observers see the drone while it waits
     */
    double missed(double until, MissedLooks.Wait wait) {
        return IntStream.range(0, sensors.size())
                .mapToDouble(sensor -> missed(sensor, until, wait))
                .reduce(1.0, (one, other) -> one * other);
    }

    /** The probability that one sensor has not detected the drone on the route by a time. */
    double missed(int sensor, double until, MissedLooks.Wait wait) {
        List<ScheduledLook> own =
                of(sensor).stream().filter(look -> look.time() <= until).toList();
        return MissedLooks.probability(own, sensors.get(sensor), wait);
    }

    private List<ScheduledLook> of(int sensor) {
        return looks.stream().filter(look -> look.number() == sensor).toList();
    }

    /**
     * For each look, in the order of {@link #looks}, the probability that its sensor has not detected the drone on the
     * route, neither in this look nor before.
     *
     * @param wait whether observers see the drone while it waits
     */
    double[] missedAfterEach(MissedLooks.Wait wait) {
        double[][] ofSensors = new double[sensors.size()][];
        Arrays.setAll(ofSensors, sensor -> MissedLooks.afterEach(of(sensor), sensors.get(sensor), wait));
        int[] taken = new int[sensors.size()];
        return looks.stream()
                .mapToDouble(look -> ofSensors[look.number()][taken[look.number()]++])
                .toArray();
    }
}
