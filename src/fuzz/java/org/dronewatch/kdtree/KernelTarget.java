package org.dronewatch.kdtree;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.fuzz.Dice;
import org.dronewatch.fuzz.Failure;
import org.dronewatch.fuzz.FuzzCase;
import org.dronewatch.fuzz.FuzzTarget;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.raster.PinholeView;
import org.dronewatch.raster.TileTracer;

/** Trees of nasty meshes; every traversal is compared with the test of each triangle. */
public final class KernelTarget implements FuzzTarget {
    private static final String FILE = "triangles.txt";
    private static final double SAME = 1e-9;
    /** A ray that passes an edge within this share of the mesh's size may hit or miss. */
    private static final double EDGE = 1e-6;

    /** A start of a ray this near to a surface, as a share of the mesh's size, lies on it. */
    private static final double NEAR = 1e-9;

    /** With more triangles, it takes too long to look at every part of every triangle. */
    private static final int MOST_VALIDATED = 300;

    private static final int PICTURE = 24;

    /** Maximum number of entries of leaves per triangle. */
    private static final int MOST_ENTRIES = 16;

    @Override
    public String name() {
        return "kernel";
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        int kind = (int) (number % FuzzMeshes.KINDS);
        return FuzzCase.of(
                "mesh of kind " + kind + " with rays",
                FILE,
                FuzzMeshes.of(kind, dice).write());
    }

    @Override
    public void judge(FuzzCase input, Path directory) {
        TriangleText text = TriangleText.read(input.text(FILE));
        TriangleMesh mesh = text.mesh();
        if (mesh.triangleCount() == 0) {
            return;
        }
        KDTree tree = KDTree.of(mesh);
        if (mesh.triangleCount() <= MOST_VALIDATED && text.hasShape()) {
            checkTree(tree);
        }
        checkSize(tree);
        BruteForce exact = new BruteForce(mesh);
        Exhaustive exhaustive = new Exhaustive(tree);
        double size = mesh.bounds().diagonal();
        for (Way way : Way.values()) {
            RayTracer traversal = way.on(tree);
            for (double[] ray : text.rays()) {
                checkRay(way, traversal, exhaustive, exact, ray, size);
            }
        }
        checkPicture(mesh, tree, exact);
    }

    private static void checkTree(KDTree tree) {
        try {
            TreeValidator.validate("tree", tree);
        } catch (AssertionError e) {
            throw new Failure("a sound tree", String.valueOf(e.getMessage()).strip());
        }
    }

    private static void checkSize(KDTree tree) {
        TriangleMesh mesh = tree.mesh();
        int most = 64 + MOST_ENTRIES * mesh.triangleCount();
        if (tree.leafTriangles().length > most) {
            throw new Failure(
                    "memory in proportion to the triangles",
                    tree.leafTriangles().length + " entries of leaves for " + mesh.triangleCount() + " triangles");
        }
    }

    /**
     * A traversal finds what the kernel's own test finds in all triangles, or what exact arithmetic finds: far from a
     * mesh the test itself may be wrong, but there no traversal asks it.
     */
    private static void checkRay(
            Way way, RayTracer traversal, Exhaustive exhaustive, BruteForce exact, double[] ray, double size) {
        double found = Way.closest(traversal, ray);
        double expected = exhaustive.closest(ray, 0.0, Double.POSITIVE_INFINITY);
        // A ray that starts on a surface may or may not meet it there.
        if (Math.min(found, expected) * length(ray) <= NEAR * size) {
            return;
        }
        double start = NEAR * size / length(ray);
        if (!same(found, expected)
                && !same(
                        found,
                        exact.closest(ray, start, Double.POSITIVE_INFINITY).distance())) {
            throw new Failure(
                    way + " hits what each triangle's own test hits",
                    (found < expected ? "too near" : found == Double.POSITIVE_INFINITY ? "a miss" : "too far") + ": "
                            + found + ", not " + expected + ", for the ray " + Arrays.toString(ray));
        }
        boolean occluded = Rays.isOccluded(traversal, ray, 0.0, Double.POSITIVE_INFINITY);
        if (occluded != found < Double.POSITIVE_INFINITY) {
            throw new Failure(
                    way + " is occluded by what it hits",
                    "occluded " + occluded + ", hit at " + found + ", for the ray " + Arrays.toString(ray));
        }
    }

    private static void checkPicture(TriangleMesh mesh, KDTree tree, BruteForce exact) {
        if (mesh.triangleCount() > 200) {
            return;
        }
        SplittableRandom random = new SplittableRandom(mesh.triangleCount());
        double size = mesh.bounds().diagonal();
        TileTracer tiles = new TileTracer(tree);
        RayTracer single = new StackTraversal(tree);
        for (int number = 0; number < 2; number++) {
            PinholeView view = PinholeView.random(mesh, random, number, PICTURE);
            int rows = 3 * PICTURE / 4;
            try {
                tiles.setPicture(view.from, view.corner, view.right, view.down);
            } catch (IllegalArgumentException e) {
                // The numbers of a view vanish if the mesh is about as small as doubles can be.
                return;
            }
            tiles.trace(0, 0, PICTURE, rows);
            for (int pixel = 0; pixel < PICTURE * rows; pixel++) {
                int column = pixel % PICTURE;
                int row = pixel / PICTURE;
                double[] ray = view.ray(column, row);
                double expected = Way.closest(single, ray);
                double found = tiles.hits(column, row) ? tiles.parameter(column, row) : Double.POSITIVE_INFINITY;
                boolean startsOnSurface = Math.min(found, expected) * length(ray) <= NEAR * size;
                boolean same = found == expected || Math.abs(found - expected) <= 1e-5 * expected || startsOnSurface;
                List<Integer> concerned = new ArrayList<>();
                if (expected < Double.POSITIVE_INFINITY) {
                    concerned.add(single.triangle());
                }
                if (tiles.hits(column, row)) {
                    concerned.add(tiles.triangle(column, row));
                }
                if (!same && concerned.stream().noneMatch(i -> exact.edgeDistance(ray, i) <= EDGE * size)) {
                    throw new Failure(
                            "tiles see what single rays see",
                            found + ", not " + expected + ", in pixel " + column + ", " + row + " of view " + number
                                    + ", the ray " + Arrays.toString(ray));
                }
            }
        }
    }

    private static double length(double[] ray) {
        return Math.sqrt(ray[3] * ray[3] + ray[4] * ray[4] + ray[5] * ray[5]);
    }

    private static boolean same(double found, double expected) {
        return found == expected || Math.abs(found - expected) <= SAME * Math.abs(expected);
    }
}
