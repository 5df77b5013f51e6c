package org.dronewatch.analysis.layer;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Optional;

/**
 * The error of a sensor's interpolated signal levels, measured at positions that were not used for the interpolation.
 *
 * @param places number of positions at which levels were traced to interpolate between them
 * @param heldOut number of positions at which levels were traced to measure the error
 * @param percentile95 the 95th percentile of the absolute error at the held-out positions, dB
 * @param ofLooks root mean square of the standard errors of the levels traced at the held-out positions, dB; a look
 *     without interpolation has the same standard error, so interpolating between more positions cannot make a field
 *     more accurate than this
 * @param inSight bounds on the error where the drone is in sight of the sensor
 * @param hidden bounds on the error where the drone is hidden from the sensor
 */
public record InterpolationError(
        int places, int heldOut, double percentile95, double ofLooks, Bounds inSight, Bounds hidden) {
    /** A field counts as accurate if its error exceeds this value, dB, at no more than 5 % of the positions. */
    public static final double ACCURATE = 0.5;

    private static final double LARGE_PART = 0.95;

    /** The quantile of the normal distribution that 95 % do not exceed on either side. */
    private static final double TWO_SIDED = 1.96;

    /** What counts as spread if all neighbours agree, dB: about the error of the traced levels. */
    private static final double LEAST_SPREAD = 0.05;

    /** How far errors that were not measured may exceed those that were. */
    private static final double MARGIN = 1.25;

    /** Fewer errors than this do not show how large they are. */
    private static final int FEWEST = 20;

    /**
     * How far errors reach.
     *
     * @param scale factor between the spread of neighbours and the standard deviation of what is interpolated between
     *     them, determined from the measured errors (root mean square)
     * @param reach the same factor for the greatest error that counts as possible: {@value InterpolationError#MARGIN}
     *     times the greatest factor measured, also at the traced positions, each of them interpolated from the others
     * @param beyond how far excesses over the open may lie beyond those of all neighbours, dB; measured in the same way
     */
    record Bounds(double scale, double reach, double beyond) {
        /** With these, nothing is certain. */
        private static final Bounds UNKNOWN =
                new Bounds(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);

        Bounds atLeast(Bounds other) {
            return new Bounds(
                    Math.max(scale, other.scale), Math.max(reach, other.reach), Math.max(beyond, other.beyond));
        }
    }

    /** The standard deviation of an estimate with a spread, dB. */
    double deviation(double spread, boolean isInSight) {
        return bounds(isInSight).scale * (LEAST_SPREAD + spread);
    }

    /** The greatest error of an estimate with a spread that counts as possible, dB. */
    double greatest(double spread, boolean isInSight) {
        return bounds(isInSight).reach * (LEAST_SPREAD + spread);
    }

    /** How far errors reach. */
    Bounds bounds(boolean isInSight) {
        return isInSight ? inSight : hidden;
    }

    /** The error of a map; if the map holds out no positions, nothing is certain with this error. */
    static InterpolationError of(ExcessMap map) {
        List<TracedPlace> heldOut = map.heldOut();
        List<Double> errors = new ArrayList<>();
        heldOut.forEach(place ->
                map.at(place.at(), place.isInSight(), place.exact()).ifPresent(its -> errors.add(error(its, place))));
        Collections.sort(errors);
        double percentile95 = errors.isEmpty() ? 0.0 : errors.get((int) Math.ceil(LARGE_PART * errors.size()) - 1);
        Optional<Bounds> seen = bounds(map, true);
        Optional<Bounds> unseen = bounds(map, false);
        Bounds all = seen.or(() -> unseen).orElse(Bounds.UNKNOWN);
        Bounds any = all.atLeast(unseen.orElse(all));
        return new InterpolationError(
                map.places().size(),
                heldOut.size(),
                percentile95,
                ofLooks(heldOut),
                seen.orElse(any),
                unseen.orElse(any));
    }

    private static double ofLooks(List<TracedPlace> heldOut) {
        return Math.sqrt(heldOut.stream()
                .mapToDouble(place -> place.signal().standardError())
                .filter(Double::isFinite)
                .map(error -> error * error)
                .average()
                .orElse(0.0));
    }

    /**
     * The 95th percentile of the absolute error that is due to the looks themselves, if this error is normally
     * distributed, dB.
     */
    public double percentile95OfLooks() {
        return TWO_SIDED * ofLooks;
    }

    private static double error(ExcessMap.Estimate estimate, TracedPlace place) {
        return Math.abs(estimate.over(place.open(), place.exact()) - place.overOpen());
    }

    /** Empty where too few positions show how far errors reach. */
    private static Optional<Bounds> bounds(ExcessMap map, boolean isInSight) {
        Reach held = new Reach();
        for (TracedPlace place : map.heldOut()) {
            if (place.isInSight() == isInSight) {
                held.add(place, map.at(place.at(), isInSight), map.at(place.at(), isInSight, place.exact()));
            }
        }
        if (held.count < FEWEST) {
            return Optional.empty();
        }
        // Few positions are held out, while fields have a hundred times as many cells, some of which are at edges and
        // close to walls, where errors are greatest.
        Reach all = new Reach();
        for (TracedPlace place : map.places()) {
            if (place.isInSight() == isInSight) {
                all.add(place, map.roughWithout(place), map.without(place));
            }
        }
        return Optional.of(new Bounds(
                Math.sqrt(held.squares / held.count),
                MARGIN * Math.max(held.most, all.most),
                MARGIN * Math.max(held.beyond, all.beyond)));
    }

    /** How far the errors at some places reach. */
    private static final class Reach {
        private double squares;
        private double most;
        private double beyond;
        private int count;

        void add(TracedPlace place, Optional<ExcessMap.Estimate> rough, Optional<ExcessMap.Estimate> its) {
            its.ifPresent(estimate -> {
                double spread = estimate.spread(place.open(), place.exact());
                double relative = error(estimate, place) / (LEAST_SPREAD + spread);
                squares += relative * relative;
                most = Math.max(most, relative);
                count++;
            });
            rough.ifPresent(estimate -> {
                beyond = Math.max(beyond, place.overOpen() - estimate.greatest());
                beyond = Math.max(beyond, estimate.least() - place.overOpen());
            });
        }
    }
}
