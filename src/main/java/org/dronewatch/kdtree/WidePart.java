package org.dronewatch.kdtree;

/** A box with two parts in it, or with triangles: what a {@link WideTree} is made from. */
final class WidePart {
    /** Low x, y, z, high x, y, z. */
    final float[] box;

    /** The first of its triangles in the builder's order. */
    final int from;

    /** Behind the last. */
    final int to;

    WidePart left;
    WidePart right;

    WidePart(float[] box, int from, int to) {
        this.box = box;
        this.from = from;
        this.to = to;
    }

    boolean isLeaf() {
        return left == null;
    }

    /** Half the surface of its box. */
    float area() {
        return WideTreeBuilder.area(box, 0);
    }
}
