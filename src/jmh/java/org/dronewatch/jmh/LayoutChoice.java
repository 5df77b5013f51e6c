package org.dronewatch.jmh;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;
import org.dronewatch.placement.KindLimits;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementObjective;
import org.dronewatch.placement.PlacementProblem;
import org.dronewatch.placement.PlacementResult;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.solver.ExactSolver;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Time of the choice among 200 candidates of eight kinds in a square of 2 km: 250 x 250 cells at four heights on eight
 * headings. Each candidate covers a sector of a disc, behind obstacles only above a random height; radars miss drones
 * that fly across their lines of sight.
 */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.SingleShotTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 1)
@Measurement(iterations = 3)
public class LayoutChoice {
    private static final int SIDE = 250;
    private static final int HEIGHTS = 4;
    private static final int HEADINGS = 8;

    /** Directions in which obstacles are as high as in the middle of them. */
    private static final int DIRECTIONS = 90;

    /** The gap at which the search ends. */
    @Param({"0.05", "0.001"})
    public double gap;

    /** The budget. */
    @Param({"60000", "150000"})
    public double budget;

    private CandidateTable table;

    /** What one sensor of a kind costs, its range in m, the width of its sector in rad, and its least radial speed. */
    private enum Kind {
        WIDE_RADAR(90_000, 700, Math.PI, 0.4, 24),
        FLAT_RADAR(75_000, 900, 0.5 * Math.PI, 0.4, 24),
        COMPACT_RADAR(40_000, 500, 0.5 * Math.PI, 0.3, 24),
        DRONE_RADAR(55_000, 600, 0.7 * Math.PI, 0.3, 24),
        RECEIVER(20_000, 800, 2.0 * Math.PI, 0.0, 20),
        MICROPHONE(15_000, 150, 2.0 * Math.PI, 0.0, 10),
        CAMERA(18_000, 400, 0.2 * Math.PI, 0.0, 54),
        THERMAL(30_000, 600, 0.2 * Math.PI, 0.0, 20);

        private final double price;
        private final double range;
        private final double width;
        private final double radial;
        private final int count;

        Kind(double price, double range, double width, double radial, int count) {
            this.price = price;
            this.range = range;
            this.width = width;
            this.radial = radial;
            this.count = count;
        }
    }

    /** Makes the table. */
    @Setup
    public void make() {
        SplittableRandom random = new SplittableRandom(1);
        List<Candidate> candidates = new ArrayList<>();
        List<CandidateColumn> columns = new ArrayList<>();
        for (Kind kind : Kind.values()) {
            for (int number = 0; number < kind.count; number++) {
                candidates.add(new Candidate(kind + "-" + number, kind.price, kind.name(), "", false));
                columns.add(column(kind, random));
            }
        }
        double[] weights = new double[SIDE * SIDE * HEIGHTS * HEADINGS];
        Arrays.fill(weights, 1.0);
        table = new CandidateTable(candidates, columns, weights);
    }

    private static CandidateColumn column(Kind kind, SplittableRandom random) {
        double cell = 2000.0 / SIDE;
        double east = random.nextDouble(-700, 700);
        double north = random.nextDouble(-700, 700);
        double aim = random.nextInt(8) * 0.25 * Math.PI;
        double[] hidden = random.doubles(DIRECTIONS, -1.0, 3.0).toArray();
        int[] rows = new int[SIDE * SIDE * HEIGHTS * HEADINGS];
        int count = 0;
        for (int at = 0; at < SIDE * SIDE * HEIGHTS; at++) {
            double x = (at % SIDE + 0.5) * cell - 1000.0 - east;
            double y = (at / SIDE % SIDE + 0.5) * cell - 1000.0 - north;
            double bearing = Math.atan2(x, y);
            int direction = (int) ((bearing / (2.0 * Math.PI) + 0.5) * DIRECTIONS) % DIRECTIONS;
            boolean isSeen = Math.hypot(x, y) < kind.range
                    && Math.abs(Math.IEEEremainder(bearing - aim, 2.0 * Math.PI)) <= 0.5 * kind.width
                    && at / (SIDE * SIDE) > hidden[direction] * Math.hypot(x, y) / kind.range;
            for (int heading = 0; isSeen && heading < HEADINGS; heading++) {
                if (Math.abs(Math.cos(bearing - 0.25 * Math.PI * heading)) >= kind.radial) {
                    rows[count++] = at * HEADINGS + heading;
                }
            }
        }
        return new CandidateColumn(Arrays.copyOf(rows, count));
    }

    /** Chooses, with at most eight radio receivers. */
    @Benchmark
    public PlacementResult choose() {
        PlacementConditions conditions = PlacementConditions.NONE
                .withBudget(budget)
                .withKinds(Map.of(Kind.RECEIVER.name(), new KindLimits(0, 8)));
        PlacementProblem problem = new PlacementProblem(table, PlacementObjective.COVERED_WEIGHT, conditions);
        return new ExactSolver()
                .solve(problem, new SolverLimits(gap, Double.POSITIVE_INFINITY, () -> false))
                .orElseThrow();
    }
}
