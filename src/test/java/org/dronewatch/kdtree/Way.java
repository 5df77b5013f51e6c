package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.function.Function;
import java.util.function.Supplier;
import org.dronewatch.bvh.TracingIndex;

/** The ways through a tree. */
enum Way {
    STACK(tree -> () -> new StackTraversal(tree)),
    SEQUENTIAL(tree -> () -> new SequentialTraversal(tree)),
    /** By vectors where the machine has them, as in the build's own tests. */
    SCATTERED(tree -> new TracingIndex(tree)::newIncoherentRayTracer);

    private final Function<KDTree, Supplier<RayTracer>> maker;

    Way(Function<KDTree, Supplier<RayTracer>> maker) {
        this.maker = maker;
    }

    RayTracer on(KDTree tree) {
        return newOn(tree).get();
    }

    /** Gives a new one each time, and prepares the tree only once. */
    Supplier<RayTracer> newOn(KDTree tree) {
        return maker.apply(tree);
    }

    /** The nearest hit, or infinity. */
    static double closest(RayTracer traversal, double[] ray) {
        return Rays.closestHit(traversal, ray) ? traversal.distance() : Double.POSITIVE_INFINITY;
    }

    /** Asserts that each ray hits, and is occluded, as if every triangle were tested, by a tracer of its own. */
    void assertSameAsExhaustive(KDTree tree, String seed, double[]... rays) {
        double end = Double.POSITIVE_INFINITY;
        Exhaustive exhaustive = new Exhaustive(tree);
        Supplier<RayTracer> tracers = newOn(tree);
        for (double[] ray : rays) {
            double expected = exhaustive.closest(ray, 0.0, end);
            RayTracer traversal = tracers.get();
            Supplier<String> what = () -> Arrays.toString(ray) + " of " + seed;

            assertThat(closest(traversal, ray)).as(what).isEqualTo(expected);
            assertThat(Rays.isOccluded(traversal, ray, 0.0, end)).as(what).isEqualTo(expected < end);
        }
    }
}
