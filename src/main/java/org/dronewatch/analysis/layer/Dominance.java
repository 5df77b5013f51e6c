package org.dronewatch.analysis.layer;

import java.util.OptionalInt;
import java.util.function.IntFunction;
import java.util.function.IntToDoubleFunction;
import java.util.function.IntUnaryOperator;
import org.dronewatch.analysis.cell.Margin;
import org.dronewatch.sensor.Cause;

/**
 * Which sensor decides in a cell: the one with the highest probability; in a tie, the one whose cause is nearest to a
 * detection in the order of {@link Cause}; then the one with the greatest margin in dB; then the first. The cause of
 * that sensor is the dominant one, which does not depend on margins.
 */
public final class Dominance {
    private static final Cause[] CAUSES = Cause.values();
    private static final int CAUSE_BITS = 4;

    private Dominance() {}

    /**
     * The rank of a sensor: the higher the probability, given in steps, the higher the rank; for equal probabilities,
     * the nearer the cause is to a detection.
     */
    public static int rank(int steps, Cause cause) {
        return steps << CAUSE_BITS | cause.ordinal();
    }

    /** The cause that a rank contains. */
    public static Cause cause(int rank) {
        return CAUSES[rank & (1 << CAUSE_BITS) - 1];
    }

    /**
     * The number of the sensor that decides.
     *
     * @param sensors number of sensors, at least one
     * @param ranks the rank of each
     * @param margins the margin of each, dB
     */
    public static int of(int sensors, IntUnaryOperator ranks, IntToDoubleFunction margins) {
        int first = 0;
        for (int sensor = 1; sensor < sensors; sensor++) {
            int more = ranks.applyAsInt(sensor) - ranks.applyAsInt(first);
            if (more > 0 || more == 0 && margins.applyAsDouble(sensor) > margins.applyAsDouble(first)) {
                first = sensor;
            }
        }
        return first;
    }

    /**
     * The number of the sensor that decides, as {@link #of} gives it, where margins are not known exactly; empty if
     * what is known of them does not suffice.
     */
    public static OptionalInt certain(int sensors, IntUnaryOperator ranks, IntFunction<Margin> margins) {
        int best = of(sensors, ranks, sensor -> margins.apply(sensor).least());
        double least = margins.apply(best).least();
        for (int sensor = 0; sensor < sensors; sensor++) {
            if (sensor != best && ranks.applyAsInt(sensor) == ranks.applyAsInt(best)) {
                double greatest = margins.apply(sensor).greatest();
                if (!(sensor < best ? least > greatest : least >= greatest)) {
                    return OptionalInt.empty();
                }
            }
        }
        return OptionalInt.of(best);
    }
}
