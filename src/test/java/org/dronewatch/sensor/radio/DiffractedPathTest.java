package org.dronewatch.sensor.radio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Random rows of hills, walls, roofs, and beams and plates in the air, 20,000 km wide, so that every path stays in one
 * plane: against {@link SlowDiffraction}.
 */
class DiffractedPathTest {
    private static final double LIGHT = 299_792_458.0;
    private static final float WIDE = 10_000_000;
    private static final double LENGTH = 500;

    /** Corners in the plane of a path, (distance, height), and the site that continues them to both sides. */
    private record Row(List<List<double[]>> lines, World world) {
        static Row of(List<List<double[]>> lines, boolean isUpright) {
            List<Float> corners = new ArrayList<>();
            List<Integer> triangles = new ArrayList<>();
            for (List<double[]> line : lines) {
                for (int i = 1; i < line.size(); i++) {
                    int first = corners.size() / 3;
                    for (double[] p : List.of(line.get(i - 1), line.get(i))) {
                        for (float side : new float[] {-WIDE, WIDE}) {
                            corners.add(isUpright ? side : (float) p[1]);
                            corners.add((float) p[0]);
                            corners.add(isUpright ? (float) p[1] : side);
                        }
                    }
                    Collections.addAll(triangles, first, first + 1, first + 3, first, first + 3, first + 2);
                }
            }
            float[] xyz = new float[corners.size()];
            for (int i = 0; i < xyz.length; i++) {
                xyz[i] = corners.get(i);
            }
            return new Row(
                    lines,
                    World.of(TriangleMesh.of(
                            xyz, triangles.stream().mapToInt(i -> i).toArray())));
        }

        /** The corners seen from one end of a path, on one side of it. */
        List<List<double[]>> along(double[] from, double[] to, double side) {
            double length = Math.hypot(to[0] - from[0], to[1] - from[1]);
            double cos = (to[0] - from[0]) / length;
            double sin = (to[1] - from[1]) / length;
            List<List<double[]>> turned = new ArrayList<>();
            for (List<double[]> line : lines) {
                List<double[]> corners = new ArrayList<>();
                for (double[] p : line) {
                    double y = p[0] - from[0];
                    double z = p[1] - from[1];
                    corners.add(new double[] {y * cos + z * sin, side * (z * cos - y * sin)});
                }
                if (line.get(0) == line.get(line.size() - 1)) {
                    corners.set(corners.size() - 1, corners.get(0));
                }
                turned.add(corners);
            }
            return turned;
        }
    }

    /** As a mesh holds it. */
    private static double[] corner(double distance, double height) {
        return new double[] {(float) distance, (float) height};
    }

    private static Row row(SplittableRandom random, boolean isUpright) {
        List<List<double[]>> lines = new ArrayList<>();
        double rough = random.nextInt(3) * 10.0;
        if (isUpright && random.nextInt(3) > 0) {
            List<double[]> ground = new ArrayList<>();
            for (double at = -300; at < LENGTH + 400; at += random.nextDouble(5, 150)) {
                ground.add(corner(at, random.nextDouble(-1, rough)));
            }
            lines.add(ground);
        }
        double low = isUpright ? -200 : random.nextDouble(-40, 40);
        for (int i = random.nextInt(6); i > 0; i--) {
            double at = random.nextDouble(-20, LENGTH + 20);
            double far = at + random.nextDouble(0.5, 40);
            double top = random.nextDouble(1, 30);
            double ridge = top + random.nextInt(2) * random.nextDouble(5);
            switch (random.nextInt(5)) {
                case 0 -> lines.add(List.of(corner(at, low), corner(at, top)));
                case 1 -> lines.add(List.of(corner(at, low), corner(at, top), corner(far, top), corner(far, low)));
                case 2 ->
                    lines.add(List.of(
                            corner(at, low),
                            corner(at, top),
                            corner((at + far) / 2, ridge),
                            corner(far, top),
                            corner(far, low)));
                case 3 -> {
                    double[] first = corner(at, top);
                    double up = top + random.nextDouble(0.5, 20);
                    lines.add(List.of(first, corner(far, top), corner(far, up), corner(at, up), first));
                }
                default -> lines.add(List.of(corner(at, top), corner(far, top + random.nextDouble(-20, 20))));
            }
        }
        if (lines.isEmpty()) {
            lines.add(List.of(corner(-100, -5), corner(LENGTH + 100, -5)));
        }
        return Row.of(lines, isUpright);
    }

    /** Some antennas are under a hill or inside a roof; there, no path leads over. */
    private static double[] end(SplittableRandom random, double at) {
        return new double[] {at, random.nextDouble(0.5, 25)};
    }

    private static Position position(double[] p) {
        return new Position(0, p[0], p[1]);
    }

    private static DiffractedPath path(World world, double[] from, double[] to, boolean above, double wavelength) {
        Section section = new Section(world);
        Position ahead =
                position(to).minus(position(from)).times(1 / position(from).distance(position(to)));
        // Towards larger heights, whatever the direction.
        Position across = new Position(0, -ahead.z(), ahead.y()).times(Math.signum(to[0] - from[0]));
        section.cut(position(from), position(to), ahead, across, 1e7);
        return new DiffractedPath(section, above, wavelength, true);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void theStringAndItsEdgesAreThoseOfASlowSearch(long build) {
        long seed = LongForm.seed(build);
        SplittableRandom random = new SplittableRandom(seed);
        int finite = 0;
        int closed = 0;
        for (int i = 0; i < LongForm.count(500, 100_000); i++) {
            Row row = row(random, true);
            double wavelength = List.of(0.03, 0.125, 2.0).get(random.nextInt(3));
            double[] from = end(random, random.nextDouble(10));
            double[] to = end(random, LENGTH);
            boolean above = random.nextInt(4) > 0;
            double side = above ? 1 : -1;
            double length = Math.hypot(to[0] - from[0], to[1] - from[1]);
            SlowDiffraction slow = new SlowDiffraction(row.along(from, to, side), length, wavelength);
            DiffractedPath path = path(row.world(), from, to, above, wavelength);

            assertThat(path.loss()).as("seed %d, row %d", seed, i).isCloseTo(slow.loss(), within(1e-4));
            assertThat(path(row.world(), to, from, above, wavelength).loss())
                    .as("from the other end, seed %d, row %d", seed, i)
                    .isCloseTo(path.loss(), within(1e-4));
            if (slow.loss() < Double.POSITIVE_INFINITY) {
                assertMain(path, slow, row.along(from, to, side));
            }
            finite += slow.loss() > 0 && slow.loss() < Double.POSITIVE_INFINITY ? 1 : 0;
            closed += slow.loss() == Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertThat(finite).isGreaterThan(150);
        assertThat(closed).isGreaterThan(20);
    }

    /** The triangle that is named ends at the edge with the greatest loss. */
    private static void assertMain(DiffractedPath path, SlowDiffraction slow, List<List<double[]>> lines) {
        double[] main = slow.main();
        if (main == null) {
            assertThat(path.triangle()).isEqualTo(-1);
            return;
        }
        // Two triangles for each piece of a line, in their order.
        int piece = path.triangle() / 2;
        for (List<double[]> line : lines) {
            if (piece >= 0 && piece < line.size() - 1) {
                assertThat(List.of(line.get(piece), line.get(piece + 1))).contains(main);
                return;
            }
            piece -= line.size() - 1;
        }
        assertThat(path.triangle()).as("a triangle of the site").isNegative();
    }

    /** Of two walls that obstruct alike, the first along the path is the main one, whatever their order in the mesh. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void ofTwoEqualEdgesTheFirstIsNamed(boolean isNearFirst) {
        List<double[]> near = List.of(corner(125, -50), corner(125, 30));
        List<double[]> far = List.of(corner(375, -50), corner(375, 30));
        World world = Row.of(isNearFirst ? List.of(near, far) : List.of(far, near), true)
                .world();
        double[] from = {0, 10};
        double[] to = {LENGTH, 10};
        assertThat(path(world, from, to, true, 0.125).triangle() / 2).isEqualTo(isNearFirst ? 0 : 1);
        assertThat(path(world, to, from, true, 0.125).triangle() / 2).isEqualTo(isNearFirst ? 1 : 0);
    }

    /** The string over the wall touches a plate that leans over the antenna: between them, no path leads out. */
    @Test
    void aPlateOverTheAntennaIsNotPassed() {
        List<double[]> wall = List.of(corner(12, -50), corner(12, 40));
        List<double[]> plate = List.of(corner(-2, 9), corner(7, 22.5));
        Row row = Row.of(List.of(wall, plate), true);
        double[] from = {0, 10};
        double[] to = {LENGTH, 10};
        assertThat(path(row.world(), from, to, true, 0.125).loss()).isInfinite();
        assertThat(path(row.world(), to, from, true, 0.125).loss()).isInfinite();
        assertThat(new SlowDiffraction(row.along(from, to, 1), LENGTH, 0.125).loss())
                .isInfinite();
    }

    /**
     * Over a row, nothing leads past its sides; past a row that stands on edge, two paths do. Wherever the search for
     * them begins.
     */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void thePathLossIsThatOfTheSlowSearch(boolean isUpright) {
        long seed = LongForm.seed(5);
        SplittableRandom random = new SplittableRandom(seed);
        int blocked = 0;
        int near = 0;
        for (int i = 0; i < LongForm.count(500, 100_000); i++) {
            Row row = row(random, isUpright);
            double frequency = List.of(1.5e7, 1.5e8, 2.4e9).get(random.nextInt(3));
            double[] from = end(random, 0);
            double[] to = end(random, LENGTH);
            double length = Math.hypot(to[0] - from[0], to[1] - from[1]);
            double one = new SlowDiffraction(row.along(from, to, 1), length, LIGHT / frequency).loss();
            double other = new SlowDiffraction(row.along(from, to, -1), length, LIGHT / frequency).loss();
            boolean isBlocked = isBlocked(row.along(from, to, 1), length);
            double past = isBlocked
                    ? Math.max(0, -10 * Math.log10(Math.pow(10, -one / 10) + Math.pow(10, -other / 10)))
                    : one + other;
            RadioPath path = new RadioPath(row.world());
            Position first = isUpright ? position(from) : new Position(from[1], from[0], 20);
            Position second = isUpright ? position(to) : new Position(to[1], to[0], 20);
            double detour = Math.pow(10, random.nextDouble(-3, 1));
            double loss = path.obstacleLoss(first, second, frequency, detour);

            // Over a row on edge, 10,000 km high, a wave loses more than 100 dB.
            double most = isUpright ? Double.POSITIVE_INFINITY : 80;
            assertThat(Math.min(most, loss))
                    .as("seed %d, row %d", seed, i)
                    .isCloseTo(Math.min(most, isUpright ? one : past), within(1e-3));
            blocked += isBlocked && loss < Double.POSITIVE_INFINITY ? 1 : 0;
            near += !isBlocked && one > 0 && other > 0 ? 1 : 0;
        }
        assertThat(blocked).isGreaterThan(50);
        assertThat(near).isPositive();
    }

    private static boolean isBlocked(List<List<double[]>> lines, double length) {
        for (List<double[]> line : lines) {
            for (int i = 1; i < line.size(); i++) {
                double[] p = line.get(i - 1);
                double[] q = line.get(i);
                double u = p[0] + p[1] / (p[1] - q[1]) * (q[0] - p[0]);
                if (p[1] > 0 != q[1] > 0 && u > 0 && u < length) {
                    return true;
                }
            }
        }
        return false;
    }
}
