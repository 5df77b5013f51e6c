package org.dronewatch.bench;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.Consumer;
import java.util.function.Function;
import org.dronewatch.bvh.TracingIndex;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.KDTreeStats;
import org.dronewatch.parallel.Workers;
import org.dronewatch.setting.Counted;
import org.jogamp.vecmath.Vector3d;

/** Measures how the costs of building trees and of tracing rays grow with the triangles of the ground. */
final class TracingStudy {
    private static final int LEAST = 1000;
    private static final int GROWTH = 5;

    private final List<TracingIndex> grounds = new ArrayList<>();
    private final int largest;
    private final Stopwatch watch;
    private final Consumer<String> progress;

    /**
     * A study.
     *
     * @param largest triangles of the largest terrain, 1000 or more
     * @param progress receives what is measured next
     */
    TracingStudy(int largest, Stopwatch watch, Consumer<String> progress) {
        this.largest = largest;
        this.watch = watch;
        this.progress = progress;
    }

    /** Builds the trees of all terrains, then traces rays in them, kind by kind. */
    List<CostCurves> run() {
        CostCurves.Points build = new CostCurves.Points("tree build, " + Counted.of(Workers.available(), "thread"));
        CostCurves.Points memory = new CostCurves.Points("tree and triangles");
        for (int size : sizes(largest)) {
            TriangleMesh mesh = RollingTerrain.of(size);
            int triangles = mesh.triangleCount();
            progress.accept(String.format(Locale.ROOT, "the tree of %,d triangles", triangles));
            build.add(triangles, watch.seconds(() -> KDTree.of(mesh)));
            KDTree tree = KDTree.of(mesh);
            memory.add(triangles, KDTreeStats.of(tree).bytes() / (double) triangles);
            grounds.add(new TracingIndex(tree));
        }
        return List.of(
                new CostCurves("build", "Building the tree", "triangles", "time [s]", List.of(build.line())),
                new CostCurves(
                        "triangles",
                        "Tracing, one thread",
                        "triangles",
                        "million rays per second",
                        List.of(
                                rates("pictures of 1920 x 1080", TraversalKind.TILES, TracingStudy::fullHd),
                                rates("pictures of 1024 x 768", TraversalKind.TILES, TracingStudy::camera),
                                rates("1024 x 768, rays one by one", TraversalKind.STACK, TracingStudy::camera),
                                rates("diffuse rays", TraversalKind.BVH, TracingStudy::diffuse))),
                new CostCurves("memory", "Memory", "triangles", "bytes per triangle", List.of(memory.line())));
    }

    /**
     * The numbers of triangles of the terrains: five times as many each time and, well above the last of these, the
     * largest.
     */
    static List<Integer> sizes(int largest) {
        List<Integer> sizes = new ArrayList<>();
        for (long size = LEAST; size < 0.9 * largest; size *= GROWTH) {
            sizes.add((int) size);
        }
        sizes.add(largest);
        return sizes;
    }

    private static RaySet fullHd(KDTree tree) {
        return generator(tree).camera(1920, 1080);
    }

    private static RaySet camera(KDTree tree) {
        return generator(tree).camera();
    }

    private static RaySet diffuse(KDTree tree) {
        return generator(tree).diffuse(camera(tree));
    }

    /** A generator of rays for ground whose z axis points up. */
    private static RayGenerator generator(KDTree tree) {
        return new RayGenerator(tree, 1, new Vector3d(0, 0, 1));
    }

    /** Traces rays of a kind in all terrains in turn: the result is how the speeds compare. */
    private CostCurves.Line rates(String name, TraversalKind kind, Function<KDTree, RaySet> rays) {
        progress.accept(name);
        List<Runnable> works = new ArrayList<>();
        List<Integer> counts = new ArrayList<>();
        for (TracingIndex index : grounds) {
            RaySet set = rays.apply(index.tree());
            counts.add(set.count());
            works.add(tracing(kind.tracers(index, set).get(), set.count()));
        }
        double[] seconds = watch.secondsInTurn(works);
        CostCurves.Points points = new CostCurves.Points(name);
        for (int i = 0; i < seconds.length; i++) {
            points.add(grounds.get(i).tree().mesh().triangleCount(), 1e-6 * counts.get(i) / seconds[i]);
        }
        return points.line();
    }

    private static Runnable tracing(Tracer tracer, int rays) {
        float[] distances = new float[rays];
        int[] triangles = new int[rays];
        return () -> {
            for (int piece = 0; piece < tracer.pieces(); piece++) {
                tracer.trace(piece, distances, triangles);
            }
        };
    }
}
