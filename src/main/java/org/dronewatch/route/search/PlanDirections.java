package org.dronewatch.route.search;

import java.util.Arrays;
import java.util.Comparator;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/**
 * The directions in plan view in which a route may leave a node, clockwise from north: each leads to another node
 * without passing through a third. The shortest path along them is longer than the straight line by a factor of at most
 * {@link #stretch()}.
 */
public final class PlanDirections {
    /** The steps in one octant, without those along the axis and the diagonal, by the total number of directions. */
    private static final Map<Integer, int[][]> STEPS = Map.of(
            8, new int[][] {}, 16, new int[][] {{2, 1}}, 32, new int[][] {{3, 1}, {2, 1}, {3, 2}}, 48, new int[][] {
                {6, 1}, {3, 1}, {2, 1}, {3, 2}, {5, 4}
            });

    private final int[][] steps;
    private final double[] headings;
    private final double widest;

    private PlanDirections(int[][] steps) {
        this.steps = steps;
        this.headings =
                Arrays.stream(steps).mapToDouble(PlanDirections::heading).toArray();
        this.widest = widest(headings);
    }

    /**
     * A set of directions.
     *
     * @param count 8, 16, 32 or 48
     * @throws IllegalArgumentException for another number
     */
    public static PlanDirections of(int count) {
        if (!STEPS.containsKey(count)) {
            throw new IllegalArgumentException(count + " directions: there must be 8, 16, 32 or 48");
        }
        return new PlanDirections(
                Stream.concat(Stream.of(new int[] {1, 0}, new int[] {1, 1}), Arrays.stream(STEPS.get(count)))
                        .flatMap(step -> Arrays.stream(new int[][] {step, {step[1], step[0]}}))
                        .flatMap(step -> Arrays.stream(
                                new int[][] {step, {-step[0], step[1]}, {step[0], -step[1]}, {-step[0], -step[1]}}))
                        .collect(Collectors.toMap(Arrays::toString, step -> step, (one, same) -> one))
                        .values()
                        .stream()
                        .sorted(Comparator.comparingDouble(PlanDirections::heading))
                        .toArray(int[][]::new));
    }

    private static double heading(int[] step) {
        double angle = StrictMath.atan2(step[0], step[1]);
        return angle < 0.0 ? angle + 2.0 * Math.PI : angle;
    }

    /** The number of directions. */
    public int count() {
        return steps.length;
    }

    /** The number of nodes by which a step leads to the east. */
    int east(int direction) {
        return steps[direction][0];
    }

    /** The number of nodes by which a step leads to the north. */
    int north(int direction) {
        return steps[direction][1];
    }

    /** The length of a step, in distances between nodes. */
    double length(int direction) {
        return Math.sqrt(east(direction) * east(direction) + north(direction) * north(direction));
    }

    /** The heading of a direction, given by its number from 0: clockwise from north, rad, 0 to 2 pi. */
    public double heading(int direction) {
        return headings[direction];
    }

    /** The largest angle between two neighbouring directions, rad. */
    double widest() {
        return widest;
    }

    private static double widest(double... headings) {
        double widest = 2.0 * Math.PI - headings[headings.length - 1];
        for (int i = 1; i < headings.length; i++) {
            widest = Math.max(widest, headings[i] - headings[i - 1]);
        }
        return widest;
    }

    /**
     * The greatest factor by which the shortest path in these directions is longer than the straight line:
     * {@code 1 / cos(half the largest angle between neighbouring directions)}, which is 1.0824, 1.0275, 1.0131 and
     * 1.0034 for 8, 16, 32 and 48 directions.
     */
    public double stretch() {
        return 1.0 / Math.cos(0.5 * widest());
    }
}
