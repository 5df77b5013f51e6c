package org.dronewatch.analysis.layer;

import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Predicate;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Signal;

/**
 * Interpolates two quantities, in dB, for any position of the drone: the amount by which the signal of one sensor
 * exceeds the signal that it would receive with nothing but air between it and the drone, and the level that the sensor
 * receives along paths that only random rays find. Values are interpolated between the nearest traced positions,
 * separately in sight of the sensor, out of sight, and where nothing arrives along deterministic paths, which are found
 * without random rays. Immutable.
 */
public final class ExcessMap {
    private static final int NEIGHBOURS = 20;

    /** Levels vary more with height than in the plane: a metre of height counts as this many. */
    private static final double VERTICAL = 3.0;

    /** Weights are this power of the reciprocal squared distance. */
    private static final double POWER = 1.5;

    /** Below any squared distance of two cells, m2. */
    private static final double SAME = 1e-6;

    private final Group inSight;
    private final Group hidden;
    private final Group reached;
    private final Group silent;
    private final Map<Position, Signal> traced = new HashMap<>();
    private final double[] box = {
        Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY, Double.NEGATIVE_INFINITY
    };
    private final InterpolationError error;
    private final List<TracedPlace> places;
    private final List<TracedPlace> heldOut;

    /**
     * Values between the nearest traced positions.
     *
     * @param rest what arrives along paths other than the exact ones, dB
     * @param leastRest the least of the neighbours' values of {@code rest}, dB
     * @param greatestRest the greatest of these values, dB
     * @param overOpen excess over the signal in the open, dB
     * @param least the least of the neighbours' values of {@code overOpen}, dB
     * @param greatest the greatest of these values, dB
     */
    record Estimate(
            double rest, double leastRest, double greatestRest, double overOpen, double least, double greatest) {
        /**
         * The amount by which the signal exceeds that in the open, dB.
         *
         * @param open the signal in the open, dB
         * @param exact by how much the signal along exact paths exceeds that in the open, dB
         */
        double over(double open, double exact) {
            return TracedPlace.together(exact, rest - open);
        }

        /** Half the difference between {@link #over} with the greatest and with the least rest of a neighbour, dB. */
        double spread(double open, double exact) {
            return 0.5
                    * (TracedPlace.together(exact, greatestRest - open)
                            - TracedPlace.together(exact, leastRest - open));
        }
    }

    private record Group(TracedPlace[] places, double[] positions) {
        static Group of(List<TracedPlace> all, Predicate<TracedPlace> which) {
            TracedPlace[] some = all.stream().filter(which).toArray(TracedPlace[]::new);
            double[] positions = new double[3 * some.length];
            for (int i = 0; i < some.length; i++) {
                positions[3 * i] = some[i].at().x();
                positions[3 * i + 1] = some[i].at().y();
                positions[3 * i + 2] = VERTICAL * some[i].at().z();
            }
            return new Group(some, positions);
        }

        /** The squared distance of a place, with height counted as {@link #VERTICAL} says, m2. */
        double square(int place, Position at) {
            double dx = positions[3 * place] - at.x();
            double dy = positions[3 * place + 1] - at.y();
            double dz = positions[3 * place + 2] - VERTICAL * at.z();
            return dx * dx + dy * dy + dz * dz;
        }

        /** Whether a place is nearer than this squared distance, m2. */
        boolean isWithin(double square, Position at) {
            for (int i = 0; i < places.length; i++) {
                if (square(i, at) < square) {
                    return true;
                }
            }
            return false;
        }
    }

    /**
     * Interpolates between positions.
     *
     * @param places the positions
     * @param heldOut others, at which the error is measured
     */
    ExcessMap(List<TracedPlace> places, List<TracedPlace> heldOut) {
        this.places = List.copyOf(places);
        this.heldOut = List.copyOf(heldOut);
        this.inSight = Group.of(places, TracedPlace::isInSight);
        this.hidden = Group.of(places, place -> !place.isInSight());
        this.reached = Group.of(places, place -> !place.isInSight() && !TracedPlace.isSilent(place.exact()));
        this.silent = Group.of(places, place -> !place.isInSight() && TracedPlace.isSilent(place.exact()));
        places.forEach(this::keep);
        heldOut.forEach(this::keep);
        this.error = InterpolationError.of(this);
    }

    private void keep(TracedPlace place) {
        traced.put(place.at(), place.signal());
        box[0] = Math.min(box[0], place.at().x());
        box[1] = Math.min(box[1], place.at().y());
        box[2] = Math.max(box[2], place.at().x());
        box[3] = Math.max(box[3], place.at().y());
    }

    /** The positions between which it interpolates. */
    List<TracedPlace> places() {
        return places;
    }

    /** Those at which the error is measured. */
    List<TracedPlace> heldOut() {
        return heldOut;
    }

    /** The error of the interpolation. */
    public InterpolationError error() {
        return error;
    }

    /** The signal at a traced position. */
    Optional<Signal> traced(Position at) {
        return Optional.ofNullable(traced.get(at));
    }

    /**
     * The value at a position, m; empty outside the area of the traced positions, and where too few of them are in
     * sight, or hidden, as this one is.
     */
    Optional<Estimate> at(Position at, boolean isInSight) {
        return in(isInSight ? inSight : hidden, at);
    }

    /**
     * The same where it is known by how much the signal along exact paths exceeds that in the open, dB: more accurate
     * out of sight.
     */
    Optional<Estimate> at(Position at, boolean isInSight, double exact) {
        return in(isInSight ? inSight : TracedPlace.isSilent(exact) ? silent : reached, at);
    }

    /**
     * Whether the traced positions nearest to a position are all in sight, or all hidden, as this one is. Elsewhere
     * a shadow boundary is near: there the level changes by several dB, in sight of the sensor, too, since the sound
     * reflected by the ground has another boundary, and the neighbours do not show by how much.
     */
    boolean isFarFromShadowBoundaries(Position at, boolean isInSight) {
        Group like = isInSight ? inSight : hidden;
        Group unlike = isInSight ? hidden : inSight;
        if (like.places.length < NEIGHBOURS) {
            return false;
        }
        double[] squares = new double[NEIGHBOURS];
        nearest(like, at, squares, null);
        return !unlike.isWithin(squares[NEIGHBOURS - 1], at);
    }

    /** The value at a traced position if it had not been traced, as by {@link #at(Position, boolean)}. */
    Optional<Estimate> roughWithout(TracedPlace place) {
        return in(place.isInSight() ? inSight : hidden, place.at(), place);
    }

    /** The same as by {@link #at(Position, boolean, double)}. */
    Optional<Estimate> without(TracedPlace place) {
        Group group = place.isInSight() ? inSight : TracedPlace.isSilent(place.exact()) ? silent : reached;
        return in(group, place.at(), place);
    }

    private Optional<Estimate> in(Group group, Position at) {
        return in(group, at, null);
    }

    /** @param omitted a place that counts as not traced, or null */
    private Optional<Estimate> in(Group group, Position at, TracedPlace omitted) {
        boolean isInside = at.x() >= box[0] && at.y() >= box[1] && at.x() <= box[2] && at.y() <= box[3];
        int fewest = omitted == null ? NEIGHBOURS : NEIGHBOURS + 1;
        return isInside && group.places.length >= fewest ? Optional.of(between(group, at, omitted)) : Optional.empty();
    }

    private static Estimate between(Group group, Position at, TracedPlace omitted) {
        double[] squares = new double[NEIGHBOURS];
        int[] nearest = nearest(group, at, squares, omitted);
        double weights = 0.0;
        double rest = 0.0;
        double lowest = Double.POSITIVE_INFINITY;
        double highest = Double.NEGATIVE_INFINITY;
        double overOpen = 0.0;
        double least = Double.POSITIVE_INFINITY;
        double greatest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < NEIGHBOURS; i++) {
            TracedPlace place = group.places[nearest[i]];
            double weight = Math.pow(squares[i] + SAME, -POWER);
            weights += weight;
            rest += weight * place.rest();
            lowest = Math.min(lowest, place.rest());
            highest = Math.max(highest, place.rest());
            overOpen += weight * place.overOpen();
            least = Math.min(least, place.overOpen());
            greatest = Math.max(greatest, place.overOpen());
        }
        if (TracedPlace.isSilent(greatest)) {
            double nothing = Double.NEGATIVE_INFINITY;
            return new Estimate(nothing, nothing, nothing, overOpen / weights, least, greatest);
        }
        return new Estimate(rest / weights, lowest, highest, overOpen / weights, least, greatest);
    }

    /** The numbers of the nearest places, the nearest one first. */
    private static int[] nearest(Group group, Position at, double[] squares, TracedPlace omitted) {
        int[] nearest = new int[NEIGHBOURS];
        Arrays.fill(squares, Double.POSITIVE_INFINITY);
        for (int i = 0; i < group.places.length; i++) {
            double square = group.places[i] == omitted ? Double.POSITIVE_INFINITY : group.square(i, at);
            int slot = NEIGHBOURS;
            while (slot > 0 && square < squares[slot - 1]) {
                slot--;
            }
            if (slot < NEIGHBOURS) {
                System.arraycopy(squares, slot, squares, slot + 1, NEIGHBOURS - slot - 1);
                System.arraycopy(nearest, slot, nearest, slot + 1, NEIGHBOURS - slot - 1);
                squares[slot] = square;
                nearest[slot] = i;
            }
        }
        return nearest;
    }
}
