package org.dronewatch.bench;

import java.util.Locale;
import java.util.function.Supplier;
import org.dronewatch.bvh.TracingIndex;
import org.dronewatch.kdtree.SequentialTraversal;

/** The traversals of a tree that can be measured. */
public enum TraversalKind {
    /**
     * The fastest for the set: tiles for a picture, fans for segments, and vector instructions, if they can be used,
     * for other sets.
     */
    FASTEST,
    /** Tiles of a picture; one ray at a time for other sets. */
    TILES,
    /** Segments with a common origin, traced together; for other sets, as BVH. */
    FAN,
    /** One ray at a time, from near to far with a stack. */
    STACK,
    /** One ray at a time, eight boxes per step with vector instructions; if these cannot be used, as STACK. */
    BVH,
    /** One ray at a time without a stack: leaf by leaf, each found by a new descent from the root. */
    SEQUENTIAL;

    /** The traversal that this kind uses for a set of rays. */
    TraversalKind of(RaySet set) {
        return switch (this) {
            case FASTEST -> set.width() > 0 ? TILES : FAN.of(set);
            case FAN -> set.query() == RaySet.Query.OCCLUDED ? FAN : BVH;
            case TILES -> set.width() > 0 ? TILES : STACK;
            default -> this;
        };
    }

    /** Creates a tracer of this kind for each thread. */
    Supplier<Tracer> tracers(TracingIndex index, RaySet set) {
        return switch (of(set)) {
            case SEQUENTIAL -> () -> new RaySetTracer(new SequentialTraversal(index.tree()), set);
            case TILES -> {
                Picture picture = new Picture(set);
                boolean[][] isTile = PictureTracer.tilesOf(picture);
                yield () -> new PictureTracer(index.tree(), set, picture, isTile);
            }
            case FAN -> () -> new FanSetTracer(index.newSegmentFan(), set);
            case BVH -> () -> new RaySetTracer(index.newIncoherentRayTracer(), set);
            default -> () -> new RaySetTracer(index.newRayTracer(), set);
        };
    }

    /** The name of this kind on the command line. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
