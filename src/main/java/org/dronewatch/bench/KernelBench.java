package org.dronewatch.bench;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.dronewatch.bvh.TracingIndex;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.parallel.Workers;

/** Traces sets of rays repeatedly and measures the time. */
public final class KernelBench {
    /**
     * Least duration of the warm-up, in which passes do not count. With a shorter one, some passes would be measured
     * before the virtual machine has compiled the tracing for the last time: one picture takes ten milliseconds, the
     * compiler half a second.
     */
    private static final Duration WARM_UP = Duration.ofSeconds(1);

    private static final int BUILDS = 3;

    private final TracingIndex index;
    private final double buildSeconds;
    private final TraversalKind kind;
    private final int threads;
    private final Duration warmUp;
    private float[] distances = new float[0];
    private int[] triangles = new int[0];

    /**
     * Builds the tree of a mesh three times and keeps the median time.
     *
     * @param threads number of threads that trace
     */
    public KernelBench(TriangleMesh mesh, TraversalKind kind, int threads) {
        this(mesh, kind, threads, WARM_UP);
    }

    KernelBench(TriangleMesh mesh, TraversalKind kind, int threads, Duration warmUp) {
        double[] seconds = new double[BUILDS];
        KDTree built = null;
        for (int i = 0; i < BUILDS; i++) {
            long start = System.nanoTime();
            built = KDTree.of(mesh);
            seconds[i] = 1e-9 * (System.nanoTime() - start);
        }
        Arrays.sort(seconds);
        this.index = new TracingIndex(built);
        this.buildSeconds = seconds[BUILDS / 2];
        this.kind = kind;
        this.threads = threads;
        this.warmUp = warmUp;
    }

    /**
     * Measures one set of rays, after warming up for at least a second and at least one pass.
     *
     * @param passes number of measured passes, 1 or more
     * @param progress receives the name of the set after the warm-up, and after each measured pass
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public TracingSpeed measure(RaySet set, int passes, Consumer<String> progress) {
        distances = new float[set.count()];
        triangles = new int[set.count()];
        double[] rates = new double[passes];
        List<Tracer> tracers =
                Stream.generate(kind.tracers(index, set)).limit(threads).toList();
        warmUp(tracers);
        progress.accept(set.name());
        for (int pass = 0; pass < passes; pass++) {
            long start = System.nanoTime();
            traceAll(tracers);
            double seconds = 1e-9 * (System.nanoTime() - start);
            rates[pass] = 1e-6 * set.count() / seconds;
            progress.accept(set.name());
        }
        Arrays.sort(rates);
        int hits =
                (int) Arrays.stream(triangles).filter(triangle -> triangle >= 0).count();
        return new TracingSpeed(
                set.name(), kind.of(set).toString(), set.count(), hits, rates[passes / 2], rates[0], rates[passes - 1]);
    }

    private void warmUp(List<Tracer> tracers) {
        long begun = System.nanoTime();
        do {
            traceAll(tracers);
        } while (System.nanoTime() - begun < warmUp.toNanos());
    }

    private void traceAll(List<Tracer> tracers) {
        AtomicInteger nextPiece = new AtomicInteger();
        List<Thread> others = new ArrayList<>();
        for (Tracer tracer : tracers.subList(1, tracers.size())) {
            Thread thread = new Thread(() -> tracePieces(tracer, nextPiece), "bench-" + others.size());
            thread.start();
            others.add(thread);
        }
        Tracer first = tracers.get(0);
        tracePieces(first, nextPiece);
        try {
            for (Thread thread : others) {
                thread.join();
            }
        } catch (InterruptedException e) {
            // The others end as soon as there is no piece left to take.
            nextPiece.set(first.pieces());
            Thread.currentThread().interrupt();
        }
        Workers.checkInterrupted();
    }

    private void tracePieces(Tracer tracer, AtomicInteger nextPiece) {
        for (int piece = nextPiece.getAndIncrement();
                piece < tracer.pieces() && !Thread.currentThread().isInterrupted();
                piece = nextPiece.getAndIncrement()) {
            tracer.trace(piece, distances, triangles);
        }
    }

    /** The tree that is traced. */
    public KDTree tree() {
        return index.tree();
    }

    /** Median time to build the tree, s. */
    public double buildSeconds() {
        return buildSeconds;
    }

    /** Distances of the hits of the set measured most recently, in the order of its rays; infinity for none. */
    public float[] distances() {
        return distances.clone();
    }

    /**
     * Triangles hit by the set measured most recently, by their number in the file; -1 for none. For segments, any
     * other number only means that the segment is blocked.
     */
    public int[] sourceTriangles() {
        return Arrays.stream(triangles)
                .map(triangle -> triangle < 0 ? -1 : tree().mesh().sourceNumber(triangle))
                .toArray();
    }
}
