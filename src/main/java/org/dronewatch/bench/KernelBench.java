package org.dronewatch.bench;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.kdtree.KDTree;

/** Traces sets of rays over and over and takes the time. */
public final class KernelBench {
    private static final int BLOCK = 4096;
    private static final int WARM_UP = 2;
    private static final int BUILDS = 3;

    private final KDTree tree;
    private final double buildSeconds;
    private final TraversalKind kind;
    private final int threads;
    private float[] distances = new float[0];
    private int[] triangles = new int[0];

    /**
     * Builds the tree of a mesh three times and keeps the median time.
     *
     * @param threads how many threads trace
     */
    public KernelBench(TriangleMesh mesh, TraversalKind kind, int threads) {
        double[] seconds = new double[BUILDS];
        KDTree built = null;
        for (int i = 0; i < BUILDS; i++) {
            long start = System.nanoTime();
            built = KDTree.of(mesh);
            seconds[i] = 1e-9 * (System.nanoTime() - start);
        }
        Arrays.sort(seconds);
        this.tree = built;
        this.buildSeconds = seconds[BUILDS / 2];
        this.kind = kind;
        this.threads = threads;
    }

    /**
     * Measures one set of rays, after two passes to warm up.
     *
     * @param passes how many passes count, 1 or more
     * @param progress is told after each pass
     */
    public Measurement measure(RaySet set, int passes, Consumer<String> progress) {
        distances = new float[set.count()];
        triangles = new int[set.count()];
        double[] rates = new double[passes];
        for (int pass = -WARM_UP; pass < passes; pass++) {
            long start = System.nanoTime();
            traceAll(set);
            double seconds = 1e-9 * (System.nanoTime() - start);
            if (pass >= 0) {
                rates[pass] = 1e-6 * set.count() / seconds;
            }
            progress.accept(set.name());
        }
        Arrays.sort(rates);
        int hits =
                (int) Arrays.stream(triangles).filter(triangle -> triangle >= 0).count();
        return new Measurement(set.name(), set.count(), hits, rates[passes / 2], rates[0], rates[passes - 1]);
    }

    /** How many passes there are in all when so many count. */
    public static int allPasses(int passes) {
        return WARM_UP + passes;
    }

    private void traceAll(RaySet set) {
        AtomicInteger nextBlock = new AtomicInteger();
        Runnable worker = () -> {
            KDTraversal traversal = kind.create(tree);
            for (int from = next(nextBlock); from < set.count(); from = next(nextBlock)) {
                trace(traversal, set, from, Math.min(from + BLOCK, set.count()));
            }
        };
        List<Thread> others = new ArrayList<>();
        for (int i = 1; i < threads; i++) {
            Thread thread = new Thread(worker, "bench-" + i);
            thread.start();
            others.add(thread);
        }
        worker.run();
        try {
            for (Thread thread : others) {
                thread.join();
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("interrupted while tracing", e);
        }
    }

    private static int next(AtomicInteger block) {
        return block.getAndAdd(BLOCK);
    }

    private void trace(KDTraversal traversal, RaySet set, int from, int to) {
        float[] r = set.rays();
        for (int ray = from; ray < to; ray++) {
            int i = ray * RaySet.FLOATS;
            boolean hit = traversal.closestHit(
                    r[i], r[i + 1], r[i + 2], r[i + 3], r[i + 4], r[i + 5], 0.0, Double.POSITIVE_INFINITY);
            distances[ray] = hit ? (float) traversal.distance() : Float.POSITIVE_INFINITY;
            triangles[ray] = hit ? traversal.triangle() : -1;
        }
    }

    /** The tree that is traced. */
    public KDTree tree() {
        return tree;
    }

    /** Median time to build the tree, s. */
    public double buildSeconds() {
        return buildSeconds;
    }

    /** Distances of the last set, in the order of its rays; infinity for none. */
    public float[] distances() {
        return distances.clone();
    }

    /** Triangles of the last set by their number in the file; -1 for none. */
    public int[] sourceTriangles() {
        return Arrays.stream(triangles)
                .map(triangle -> triangle < 0 ? -1 : tree.mesh().sourceNumber(triangle))
                .toArray();
    }
}
