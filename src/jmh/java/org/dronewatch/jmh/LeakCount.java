package org.dronewatch.jmh;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.concurrent.atomic.AtomicLong;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.Meshes;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;

/**
 * Counts the random rays that get out of a closed mesh; there should be none. Arguments, all optional: {@code ball} or
 * {@code room}, number of rays (rounded up to whole blocks), seed. Prints one line.
 */
public final class LeakCount {
    private static final int THREADS = 2;
    private static final int BLOCK = 1 << 18;

    private final KDTree tree;
    private final long rays;
    private final long seed;
    private final AtomicLong nextBlock = new AtomicLong();
    private final AtomicLong leaks = new AtomicLong();

    private LeakCount(KDTree tree, long rays, long seed) {
        this.tree = tree;
        this.rays = (rays + BLOCK - 1) / BLOCK * BLOCK;
        this.seed = seed;
    }

    /** Traces the rays and prints the result. */
    public static void main(String[] arguments) throws InterruptedException {
        String name = arguments.length > 0 ? arguments[0] : "ball";
        long rays = arguments.length > 1 ? Long.parseLong(arguments[1]) : 100_000_000;
        long seed = arguments.length > 2 ? Long.parseLong(arguments[2]) : 1;
        TriangleMesh mesh = name.equals("room") ? Meshes.room() : Meshes.icosphere(5);
        LeakCount count = new LeakCount(KDTree.of(mesh), rays, seed);
        long start = System.nanoTime();
        count.run();
        double seconds = 1e-9 * (System.nanoTime() - start);
        System.out.printf(
                Locale.ROOT,
                "%s: triangles %d, rays %d, seed %d, leaks %d, seconds %.1f%n",
                name,
                mesh.triangleCount(),
                count.rays,
                seed,
                count.leaks.get(),
                seconds);
    }

    private void run() throws InterruptedException {
        List<Thread> threads = new ArrayList<>();
        for (int i = 0; i < THREADS; i++) {
            threads.add(new Thread(this::traceBlocks));
        }
        threads.forEach(Thread::start);
        for (Thread thread : threads) {
            thread.join();
        }
    }

    private void traceBlocks() {
        RayTracer traversal = new StackTraversal(tree);
        for (long block = nextBlock.getAndIncrement(); block * BLOCK < rays; block = nextBlock.getAndIncrement()) {
            leaks.addAndGet(leaksOfBlock(traversal, new SplittableRandom(seed + block)));
        }
    }

    /** Rays from the middle half of the mesh's box, in uniform directions. */
    private int leaksOfBlock(RayTracer traversal, SplittableRandom random) {
        AABB box = tree.bounds();
        int missed = 0;
        for (int i = 0; i < BLOCK; i++) {
            double ox = between(box.minX(), box.maxX(), random);
            double oy = between(box.minY(), box.maxY(), random);
            double oz = between(box.minZ(), box.maxZ(), random);
            double dz = 2.0 * random.nextDouble() - 1.0;
            double angle = 2.0 * Math.PI * random.nextDouble();
            double radius = Math.sqrt(1.0 - dz * dz);
            boolean hit = traversal.closestHit(
                    ox, oy, oz, radius * Math.cos(angle), radius * Math.sin(angle), dz, 0.0, Double.POSITIVE_INFINITY);
            missed += hit ? 0 : 1;
        }
        return missed;
    }

    private static double between(double low, double high, SplittableRandom random) {
        return low + (high - low) * (0.25 + 0.5 * random.nextDouble());
    }
}
