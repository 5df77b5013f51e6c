package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.raster.TileTracer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Rays through edges and corners of lattices of unit right triangles, where planes of the tree lie too: which cell such
 * a ray enters is up to rounding, what it hits must not be.
 */
class TraversalLatticeTest {
    private static final double END = Double.POSITIVE_INFINITY;

    /**
     * A stack ends in the first cell with a hit; of triangles that meet in that point another may be nearer by
     * roundings.
     */
    private static final double ROUNDINGS = 1e-14;

    @ParameterizedTest
    @EnumSource
    void aRayTowardsACornerOfTheLattice(Way way) {
        KDTree tree = KDTree.of(NastyMeshes.lattice(4, 0.2, 2));
        assertFindsAll(
                way,
                way.on(tree),
                new Exhaustive(tree),
                new double[] {-2.0, 3.0, 3.0, 1.3333333333333333, -0.6666666666666666, -0.3333333333333333},
                "the first ray that was lost");
    }

    /** From all half points in and about the lattice to all half points in it. */
    @ParameterizedTest
    @EnumSource
    void allRaysOfSmallLattices(Way way) {
        for (int seed = 0; seed < 12; seed++) {
            int cells = seed < 9 ? 1 : 2;
            KDTree tree = KDTree.of(NastyMeshes.lattice(cells, seed == 0 ? 1.0 : 0.25, seed));
            RayTracer traversal = way.on(tree);
            Exhaustive exhaustive = new Exhaustive(tree);
            int reach = 2 * cells + 1;
            int origins = reach + 4;
            for (int from = 0; from < origins * origins * origins; from += cells) {
                double[] origin = halfPoint(from, origins, -1.0);
                for (int to = 0; to < reach * reach * reach; to += cells) {
                    double[] ray = Rays.towards(origin, halfPoint(to, reach, 0.0));
                    assertFindsAll(way, traversal, exhaustive, ray, "lattice of seed " + seed);
                }
            }
        }
    }

    private static double[] halfPoint(int number, int perAxis, double first) {
        return new double[] {
            first + 0.5 * (number % perAxis),
            first + 0.5 * (number / perAxis % perAxis),
            first + 0.5 * (number / perAxis / perAxis)
        };
    }

    /**
     * Larger lattices, small, far from the origin, off the grid of planes; directions of any length, zeros of both
     * signs.
     */
    @Thorough
    @ParameterizedTest
    @EnumSource
    void raysOfLatticesOfAnySizeAndPosition(Way way) {
        double[] factors = {1.0, 1e-3, 1.0, 0.3, 1e5, 1.0};
        double[] shifts = {0.0, 0.0, 1e5, -0.1, -2e5, -2.0};
        double[] lengths = {1.0, 0.1, 1.0 / 3.0, 7.0, 1e-3, 1e5};
        double[] shares = {1.0, 0.5, 0.2, 0.1, 0.04};
        for (int seed = 0; seed < 60; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            int cells = 2 + seed % 4;
            double factor = factors[seed % 6];
            double shift = shifts[seed % 6];
            TriangleMesh lattice = NastyMeshes.lattice(cells, shares[seed % 5], seed);
            KDTree tree = KDTree.of(NastyMeshes.moved(lattice, factor, shift));
            RayTracer traversal = way.on(tree);
            Exhaustive exhaustive = new Exhaustive(tree);
            for (int i = 0; i < 2000; i++) {
                int perUnit = 1 + random.nextInt(2);
                double[] from = new double[3];
                double[] to = new double[3];
                for (int axis = 0; axis < 3; axis++) {
                    double a = (double) random.nextInt((cells + 4) * perUnit) / perUnit - 2;
                    double b = (double) random.nextInt(cells * perUnit + 1) / perUnit;
                    from[axis] = (float) (factor * a + shift);
                    to[axis] = (float) (factor * b + shift);
                }
                double[] ray = Rays.towards(from, to);
                double length = lengths[random.nextInt(lengths.length)];
                for (int k = 3; k < 6; k++) {
                    ray[k] *= ray[k] == 0.0 && random.nextBoolean() ? -length : length;
                }
                assertFindsAll(way, traversal, exhaustive, ray, "seed " + seed + ", ray " + i);
            }
        }
    }

    /** Rays that meet the mesh's box in an edge or a corner only. */
    @ParameterizedTest
    @EnumSource
    void raysThatTouchTheBoxFromOutside(Way way) {
        KDTree tree = KDTree.of(NastyMeshes.lattice(3, 1.0, 1));
        RayTracer traversal = way.on(tree);
        Exhaustive exhaustive = new Exhaustive(tree);
        SplittableRandom random = new SplittableRandom(95);
        int touched = 0;
        for (int i = 0; i < 20_000; i++) {
            int axis = random.nextInt(3);
            int second = (axis + 1) % 3;
            double[] ray = new double[6];
            double side = random.nextInt(2);
            double[] slope = {(1 + random.nextInt(8)) / 3.0, (1 + random.nextInt(8)) / 7.0};
            double back = 1 + random.nextInt(5);
            // Towards a point of an edge of the box, rising on one axis outwards while it falls on the other inwards.
            ray[axis] = 3 * side + (side == 0 ? 1 : -1) * slope[0] * back;
            ray[3 + axis] = (side == 0 ? -1 : 1) * slope[0];
            ray[second] = -slope[1] * back;
            ray[3 + second] = slope[1];
            ray[3 - axis - second] = 0.5 * random.nextInt(7);
            touched += exhaustive.closest(ray, 0.0, END) < END ? 1 : 0;
            assertFindsAll(way, traversal, exhaustive, ray, "seed 95, ray " + i);
        }
        assertThat(touched).as("rays of seed 95 that hit").isGreaterThan(1000);
    }

    /**
     * The rays of a tile share an origin on the lattice, or between, and end in half points of one of its planes. A
     * tile decides by roundings of its own whether a lone edge belongs to its triangle; but nothing slips between
     * triangles.
     */
    @Test
    void picturesOfLattices() {
        for (int seed = 0; seed < 300; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            boolean full = seed % 2 == 0;
            KDTree tree = KDTree.of(NastyMeshes.lattice(3, full ? 1.0 : 0.3, seed));
            BruteForce bruteForce = new BruteForce(tree.mesh());
            int axis = seed % 3;
            double[] origin = new double[3];
            double[] corner = new double[3];
            double[] right = new double[3];
            double[] down = new double[3];
            Arrays.setAll(origin, k -> k == axis ? -1 : 0.5 * random.nextInt(11) - 1);
            Arrays.setAll(corner, k -> k == axis ? 1 + random.nextInt(4) : -origin[k]);
            right[(axis + 1) % 3] = 0.5;
            down[(axis + 2) % 3] = 0.5;
            TileTracer tiles = new TileTracer(tree);
            tiles.setPicture(origin, corner, right, down);
            tiles.trace(0, 0, 7, 7);
            for (int pixel = 0; pixel < 49; pixel++) {
                int column = pixel % 7;
                int row = pixel / 7;
                double[] ray = Rays.ray(origin, corner);
                for (int k = 0; k < 3; k++) {
                    ray[3 + k] += column * right[k] + row * down[k];
                }
                BruteForce.Answer expected = bruteForce.closest(ray);
                double found = tiles.hits(column, row) ? tiles.parameter(column, row) : END;
                if (found == expected.distance() || Math.abs(found - expected.distance()) < 1e-12) {
                    continue;
                }
                int nearer = found < expected.distance() ? tiles.triangle(column, row) : expected.triangle();
                String what = "seed " + seed + ", " + Arrays.toString(ray) + " at " + found + ", not " + expected;
                assertThat(bruteForce.edgeDistance(ray, nearer)).as(what).isLessThan(1e-12);
                if (full) {
                    assertThat(facesMet(ray, Math.min(found, expected.distance())))
                            .as(what)
                            .isGreaterThan(1);
                }
            }
        }
    }

    /** In how many of the faces of the lattice's cube a point of a ray lies. */
    private static long facesMet(double[] ray, double t) {
        return IntStream.range(0, 3)
                .mapToDouble(k -> ray[k] + t * ray[3 + k])
                .filter(x -> Math.abs(x) < 1e-9 || Math.abs(x - 3) < 1e-9)
                .count();
    }

    private static void assertFindsAll(Way way, RayTracer traversal, Exhaustive exhaustive, double[] ray, String name) {
        double expected = exhaustive.closest(ray, 0.0, END);
        double found = Way.closest(traversal, ray);
        if (found != expected && (way != Way.STACK || !isNear(found, expected))) {
            assertThat(found).as("%s, %s", Arrays.toString(ray), name).isEqualTo(expected);
        }
        if (startsOnSurface(ray, expected)) {
            return;
        }
        boolean occluded = expected < END;
        if (Rays.isOccluded(traversal, ray, 0.0, END) != occluded) {
            assertThat(!occluded)
                    .as("occlusion of %s, %s", Arrays.toString(ray), name)
                    .isEqualTo(occluded);
        }
    }

    /** Whether a hit is no farther than rounding: whether it counts as an occlusion is a matter of rounding, too. */
    private static boolean startsOnSurface(double[] ray, double distance) {
        double size = Math.max(Math.abs(ray[0]), Math.max(Math.abs(ray[1]), Math.abs(ray[2])));
        double speed = Math.max(Math.abs(ray[3]), Math.max(Math.abs(ray[4]), Math.abs(ray[5])));
        return Math.abs(distance) * speed < 1e-9 * (size + 1e-3);
    }

    private static boolean isNear(double found, double expected) {
        return found >= expected && found <= expected * (1 + ROUNDINGS);
    }
}
