package org.dronewatch.route.proof;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.IntStream;
import org.apache.commons.numbers.gamma.Erfc;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.parallel.Workers;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.run.EmissionTime;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.SensorSettings;

/**
 * All looks that a run takes at its only drone, each assessed exactly where it is taken: at the time, the position, the
 * heading and the speed of the run, and with the pointing of a positioner that only searches. Looks before the route
 * begins, while the drone waits, do not count. Immutable.
 */
final class LookSchedule {
    /** A level this many standard errors or fewer from its threshold may be on the other side of it with other rays. */
    private static final double STANDARD_ERRORS = 8.0;

    /** How often such a level is estimated. */
    private static final int LEVELS = 64;

    private final List<SensorSettings<?>> sensors;
    private final List<ScheduledLook> looks;
    private final double begin;

    private LookSchedule(List<SensorSettings<?>> sensors, List<ScheduledLook> looks, double begin) {
        this.sensors = List.copyOf(sensors);
        this.looks = List.copyOf(looks);
        this.begin = begin;
    }

    /**
     * Assesses all looks, on the {@link Workers} of the calling thread.
     *
     * @param settings of a scene with one drone, {@linkplain RouteScene#withoutCues without cues}
     * @param stage of the same scene
     * @param estimates of a probability that is estimated from random rays: it is their mean
     */
    static LookSchedule of(SceneSettings settings, Stage stage, int estimates) {
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
                boolean counts = time >= begin;
                // What an observer sees of the drone before decides which encounter follows.
                if (left.isPresent() && (counts || one.chance() == Chance.PER_ENCOUNTER)) {
                    taken.add(
                            new ScheduledLook(sensor, look, drone.at(path.at(left.getAsDouble())), 0.0, true, counts));
                }
            }
        }
        return new LookSchedule(sensors, assessed(taken, names, sensors, stage, estimates), begin);
    }

    private static List<ScheduledLook> assessed(
            List<ScheduledLook> taken,
            List<String> names,
            List<SensorSettings<?>> sensors,
            Stage stage,
            int estimates) {
        ScheduledLook[] assessed = new ScheduledLook[taken.size()];
        Workers.forEach(taken.size(), () -> new Assessor[sensors.size()], (assessors, i) -> {
            ScheduledLook look = taken.get(i);
            int sensor = look.number();
            if (assessors[sensor] == null) {
                assessors[sensor] = new Assessor(names.get(sensor), sensors.get(sensor), stage.world());
            }
            assessed[i] = assessed(assessors[sensor], look, estimates);
        });
        return Arrays.stream(assessed)
                .sorted(Comparator.comparingDouble(ScheduledLook::time))
                .toList();
    }

    private static ScheduledLook assessed(Assessor assessor, ScheduledLook look, int estimates) {
        Assessment first = assess(assessor, look, 0);
        boolean isNear = Math.abs(first.margin()) < STANDARD_ERRORS * first.standardError();
        boolean isEstimated = first.probabilityError() > 0.0 || isNear;
        double mean = first.probability();
        if (isNear && estimates > 1) {
            mean = chanceOfLevel(assessor, look, first);
        } else if (isEstimated) {
            for (int estimate = 1; estimate < estimates; estimate++) {
                mean += assess(assessor, look, estimate).probability();
            }
            mean /= estimates;
        }
        return new ScheduledLook(look.number(), look.look(), look.drone(), mean, isEstimated, look.counts());
    }

    /**
     * The probability that a level with other rays reaches the threshold, if levels are normally distributed. A few
     * looks near the threshold decide a whole flight, so that each of these is estimated often.
     */
    private static double chanceOfLevel(Assessor assessor, ScheduledLook look, Assessment first) {
        double[] margins = new double[LEVELS];
        margins[0] = first.margin();
        for (int estimate = 1; estimate < LEVELS; estimate++) {
            margins[estimate] = assess(assessor, look, estimate).margin();
        }
        double mean = Arrays.stream(margins).average().orElseThrow();
        double squares =
                Arrays.stream(margins).map(one -> (one - mean) * (one - mean)).sum();
        double deviation = Math.sqrt(squares / (LEVELS - 1) * (1.0 + 1.0 / LEVELS));
        if (!(deviation > 0.0)) {
            // All are the same, or no ray has arrived in some.
            return (double) Arrays.stream(margins).filter(one -> one >= 0.0).count() / LEVELS;
        }
        return 0.5 * Erfc.value(-mean / (Math.sqrt(2.0) * deviation));
    }

    /** The first with the rays of the look itself, the others with those of other seeds. */
    private static Assessment assess(Assessor assessor, ScheduledLook look, int estimate) {
        Look its = look.look();
        long seed = Draws.derivedSeed(its.seed(), "estimate", estimate);
        String drone = look.drone().id();
        return assessor.assess(
                look.drone(), its.pointing(), Draws.stream(seed, its.sensor(), drone, its.index(), RaySensor.RAYS));
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
     * @param wait what observers make of the drone while it waits
     */
    double missed(double until, MissedLooks.Wait wait) {
        return IntStream.range(0, sensors.size())
                .mapToDouble(sensor -> missed(sensor, until, wait))
                .reduce(1.0, (one, other) -> one * other);
    }

    /** The same of one sensor. */
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
     */
    double[] missedAfterEach() {
        double[][] ofSensors = new double[sensors.size()][];
        Arrays.setAll(
                ofSensors, sensor -> MissedLooks.afterEach(of(sensor), sensors.get(sensor), MissedLooks.Wait.UNSEEN));
        int[] taken = new int[sensors.size()];
        return looks.stream()
                .mapToDouble(look -> ofSensors[look.number()][taken[look.number()]++])
                .toArray();
    }
}
