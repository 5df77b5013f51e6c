package org.dronewatch.analysis;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.DoublePredicate;
import java.util.function.LongPredicate;
import org.dronewatch.drone.Drone;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.Thresholded;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;

/**
 * A calibration: the threshold at which a sensor detects a drone up to a given range, given a clear line of sight and
 * the air, background noise, rain and light of a scene, without its models and noise sources. It uses
 * {@link org.dronewatch.sensor.AssessableSensor#signal}, not runs, so the result does not depend on chance.
 *
 * @param sensor the sensor with its fitted threshold
 * @param scale the setting that was fitted
 * @param threshold the fitted value, in the unit of the scale
 * @param ranges greatest range at which the drone is detected, by value of the threshold, m: for the fitted value and,
 *     if the threshold is a whole number, also for the values one below and one above it; NaN for a value with which
 *     the drone is not detected at any range
 */
public record Calibration(
        SensorSettings<?> sensor, Thresholded.Scale scale, double threshold, Map<Double, Double> ranges) {
    /** The shortest range to which a sensor can be fitted, m: at shorter ranges, no sensor model is meaningful. */
    public static final double NEAREST = 1.0;

    /** The longest range to which a sensor can be fitted, m. */
    public static final double FARTHEST = In.FARTHEST;

    /** The greatest distance between the ranges at which a pixel count is evaluated, as a fraction of the range. */
    private static final double STEP = 1e-3;

    /** The greatest distance between the ranges at which a pixel count is evaluated near the sensor, m. */
    private static final double NEAREST_STEP = 1e-2;

    /**
     * The number of ranges at which a count is evaluated within the distance that the drone flies between two looks.
     * Counts do not fall monotonically: a farther stretch, shorter than this distance, in which the drone covers one
     * pixel more may fall between two looks.
     */
    private static final double PER_LOOK = 4.0;

    /** How precisely ranges are found, as a fraction of the range. */
    private static final double PRECISION = 1e-9;

    /** Copies the map: later changes by the caller have no effect. */
    public Calibration {
        ranges = Map.copyOf(ranges);
    }

    /**
     * Fits a sensor.
     *
     * @param settings the scene
     * @param drone the drone, in any state
     * @param sensor name of the sensor, one of the scene's
     * @param range greatest range at which the drone is to be detected, {@link #NEAREST} to {@link #FARTHEST}, m
     * @param probability minimum probability that a look at this range detects it, above 0 and at most 1
     * @throws InputException when the sensor has no threshold to fit, or no value of the threshold gives the range
     */
    public static Calibration of(SceneSettings settings, Drone drone, String sensor, double range, double probability) {
        SensorSettings<?> own = settings.sensors().get(sensor);
        Thresholded fitted = own.as(Thresholded.class)
                .orElseThrow(() -> new InputException("sensor '" + sensor + "' of kind " + own.kind()
                        + " has no threshold to fit: 'calibrate' is for acoustic and rf sensors, and for cameras with"
                        + " detection: pixel-threshold"));
        FreeSight sight =
                FreeSight.in(settings.world(), drone, sensor, settings.run().seed());
        return new Search(sight, fitted, sensor, probability, drone.settings().speed() / own.rate()).fit(range);
    }

    /** The greatest range with the fitted threshold, m. */
    public double range() {
        return ranges.get(threshold);
    }

    /**
     * One search: all that does not change from threshold to threshold.
     *
     * @param perLook how far the drone flies between two looks, m
     */
    private record Search(FreeSight sight, Thresholded sensor, String name, double probability, double perLook) {

        Calibration fit(double range) {
            Thresholded.Scale scale = sensor.thresholdScale();
            long hardest = last(scale, number -> isDetected(scale.value(number), range));
            boolean isTooFar = hardest < 0;
            if (isTooFar || hardest == scale.last() && isDetected(scale.highest(), beyond(range))) {
                throw outOfReach(scale, range);
            }
            Map<Double, Double> ranges = new LinkedHashMap<>();
            double best = scale.value(hardest);
            ranges.put(best, isWhole(scale) ? greatestByCount(best, range) : greatest(best));
            if (isWhole(scale)) {
                if (Double.isNaN(ranges.get(best))) {
                    throw outOfReach(scale, range);
                }
                // The next whole number may give a range closer to the requested one, from below.
                double next = scale.value(Math.min(hardest + 1, scale.last()));
                double nextRange = greatestByCount(next, range);
                ranges.put(next, nextRange);
                best = Math.abs(nextRange - range) < Math.abs(ranges.get(best) - range) ? next : best;
                for (double other : new double[] {best - 1.0, best + 1.0}) {
                    if (other >= scale.lowest() && other <= scale.highest()) {
                        ranges.computeIfAbsent(other, count -> greatestByCount(count, range));
                    }
                }
                double chosen = best;
                ranges.keySet().removeIf(count -> Math.abs(count - chosen) > 1.0);
            }
            return new Calibration(sensor.withThreshold(best), scale, best, ranges);
        }

        private static boolean isWhole(Thresholded.Scale scale) {
            return scale.step() == 1.0;
        }

        private static double beyond(double range) {
            return range * (1.0 + STEP);
        }

        private boolean isDetected(double threshold, double range) {
            return sight.of(sensor.withThreshold(threshold)).at(range) >= probability;
        }

        /** The greatest number of a scale that passes; -1 when not even the first does. */
        private static long last(Thresholded.Scale scale, LongPredicate passes) {
            if (!passes.test(0)) {
                return -1;
            }
            long yes = 0;
            long no = scale.last() + 1;
            while (no - yes > 1) {
                long middle = yes + (no - yes) / 2;
                if (passes.test(middle)) {
                    yes = middle;
                } else {
                    no = middle;
                }
            }
            return yes;
        }

        /** The greatest range at which a drone is detected with a threshold, m; NaN when there is none. */
        private double greatest(double threshold) {
            FreeSight.Probability look = sight.of(sensor.withThreshold(threshold));
            DoublePredicate detects = range -> look.at(range) >= probability;
            if (detects.test(FARTHEST)) {
                return FARTHEST;
            }
            return detects.test(NEAREST) ? between(detects, NEAREST, FARTHEST) : Double.NaN;
        }

        /**
         * The greatest range from which a drone that comes nearer fills the required number of pixels for the distance
         * flown between two looks, or down to {@link #NEAREST}; searched for from far away inwards, m; NaN when there
         * is none.
         */
        private double greatestByCount(double threshold, double about) {
            FreeSight.Probability look = sight.of(sensor.withThreshold(threshold));
            DoublePredicate detects = range -> look.at(range) >= probability;
            double far = about;
            while (far < FARTHEST && detects.test(far)) {
                far *= 2.0;
            }
            far = Math.min(FARTHEST, 2.0 * far);
            double step = Math.min(Math.max(STEP * about, NEAREST_STEP), perLook / PER_LOOK);
            long needed = Math.max(1, (long) Math.ceil(perLook / step));
            long held = 0;
            long number = (long) Math.floor(far / step);
            while (number * step >= NEAREST && held < needed) {
                held = detects.test(number * step) ? held + 1 : 0;
                number--;
            }
            if (held < needed && !detects.test(NEAREST)) {
                return Double.NaN;
            }
            double reached = held == 0 ? NEAREST : (number + held) * step;
            return between(detects, reached, Math.min(FARTHEST, (number + held + 1) * step));
        }

        /** The limit between two ranges, by bisection on the logarithm of the range. */
        private static double between(DoublePredicate detects, double yes, double no) {
            double near = yes;
            double far = no;
            while (far > near * (1.0 + PRECISION)) {
                double middle = Math.sqrt(near * far);
                if (middle <= near || middle >= far) {
                    break;
                }
                if (detects.test(middle)) {
                    near = middle;
                } else {
                    far = middle;
                }
            }
            return near;
        }

        private InputException outOfReach(Thresholded.Scale scale, double range) {
            String what = Quantity.LENGTH.inWords(range) + " cannot be reached by sensor '" + name + "'";
            String whom = "drone '" + sight.drone().id() + "'";
            double farthest = greatest(scale, scale.lowest());
            if (Double.isNaN(farthest)) {
                return new InputException(what + ": whatever its " + scale.setting() + ", it does not detect " + whom
                        + " at " + Quantity.LENGTH.inWords(NEAREST) + " or farther");
            }
            double nearest = greatest(scale, scale.highest());
            return new InputException(what + ": with " + scale.setting() + " from "
                    + scale.quantity().inWords(scale.highest()) + " to "
                    + scale.quantity().inWords(scale.lowest()) + " it detects " + whom + " from "
                    + toTheMillimetre(Double.isNaN(nearest) ? NEAREST : nearest) + " to "
                    + toTheMillimetre(farthest));
        }

        private static String toTheMillimetre(double range) {
            return Quantity.LENGTH.inWords(Math.rint(1e3 * range) / 1e3);
        }

        private double greatest(Thresholded.Scale scale, double threshold) {
            double found = greatest(threshold);
            return Double.isNaN(found) || !isWhole(scale) ? found : greatestByCount(threshold, found);
        }
    }
}
