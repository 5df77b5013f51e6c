package org.dronewatch.kdtree;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Arrays;
import java.util.function.Function;
import org.dronewatch.bvh.TracingIndex;

/** The ways through a tree. */
enum Way {
    STACK(StackTraversal::new),
    SEQUENTIAL(SequentialTraversal::new),
    /** By vectors where the machine has them, as in the build's own tests. */
    SCATTERED(tree -> new TracingIndex(tree).newIncoherentRayTracer());

    private final Function<KDTree, RayTracer> maker;

    Way(Function<KDTree, RayTracer> maker) {
        this.maker = maker;
    }

    RayTracer on(KDTree tree) {
        return maker.apply(tree);
    }

    /** The nearest hit, or infinity. */
    static double closest(RayTracer traversal, double[] ray) {
        return Rays.closestHit(traversal, ray) ? traversal.distance() : Double.POSITIVE_INFINITY;
    }

    /** Asserts that a ray hits, and is occluded, as if every triangle were tested. */
    void assertSameAsExhaustive(KDTree tree, double[] ray, String seed) {
        double end = Double.POSITIVE_INFINITY;
        double expected = new Exhaustive(tree).closest(ray, 0.0, end);
        RayTracer traversal = on(tree);
        String what = Arrays.toString(ray) + " of " + seed;

        assertThat(closest(traversal, ray)).as(what).isEqualTo(expected);
        assertThat(Rays.isOccluded(traversal, ray, 0.0, end)).as(what).isEqualTo(expected < end);
    }
}
