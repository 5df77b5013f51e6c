package org.dronewatch.jmh;

import java.util.concurrent.TimeUnit;
import org.dronewatch.bench.RaySet;
import org.dronewatch.bvh.TracingIndex;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.SequentialTraversal;
import org.dronewatch.kdtree.StackTraversal;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/**
 * Time of a ray through a tree, and what it allocates: coherent rays of a picture, incoherent ones of diffuse walls.
 */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 2)
@Measurement(iterations = 3, time = 2)
public class ClosestHit {
    private static final int BATCH = 16_384;

    /** The model to trace. */
    @Param({"hill", "quadrotor", "cathedral"})
    public String model;

    /** The similarity of neighbouring rays. */
    @Param({"camera", "diffuse"})
    public String rays;

    /** The way through the tree. */
    @Param({"stack", "sequential", "incoherent"})
    public String kind;

    private RayTracer traversal;
    private RaySet set;
    private int next;

    /** Loads the model and makes the rays. */
    @Setup
    public void load() {
        KDTree tree = KDTree.of(Bench.mesh(model));
        traversal = switch (kind) {
            case "stack" -> new StackTraversal(tree);
            case "sequential" -> new SequentialTraversal(tree);
            default -> new TracingIndex(tree).newIncoherentRayTracer();
        };
        set = Bench.rays(tree, rays);
    }

    /** The nearest triangle along each of a batch of rays. */
    @Benchmark
    @OperationsPerInvocation(BATCH)
    public double closestHit() {
        float[] r = set.rays();
        double sum = 0.0;
        for (int ray = 0; ray < BATCH; ray++) {
            int i = nextRay();
            if (traversal.closestHit(
                    r[i], r[i + 1], r[i + 2], r[i + 3], r[i + 4], r[i + 5], 0.0, Double.POSITIVE_INFINITY)) {
                sum += traversal.distance();
            }
        }
        return sum;
    }

    /** Whether anything is on each of a batch of rays. */
    @Benchmark
    @OperationsPerInvocation(BATCH)
    public int occlusion() {
        float[] r = set.rays();
        int occluded = 0;
        for (int ray = 0; ray < BATCH; ray++) {
            int i = nextRay();
            if (traversal.isOccluded(
                    r[i], r[i + 1], r[i + 2], r[i + 3], r[i + 4], r[i + 5], 0.0, Double.POSITIVE_INFINITY)) {
                occluded++;
            }
        }
        return occluded;
    }

    private int nextRay() {
        int ray = next;
        next = ray + 1 == set.count() ? 0 : ray + 1;
        return ray * RaySet.FLOATS;
    }
}
