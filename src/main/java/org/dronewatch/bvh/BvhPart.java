package org.dronewatch.bvh;

/** A node of the tree from which a {@link Bvh} is made: it has either two parts or triangles. */
final class BvhPart {
    /** Low x, y, z, high x, y, z. */
    final float[] box;

    /** The first of its triangles in the builder's order. */
    final int from;

    /** The index after the last. */
    final int to;

    BvhPart left;
    BvhPart right;

    BvhPart(float[] box, int from, int to) {
        this.box = box;
        this.from = from;
        this.to = to;
    }

    boolean isLeaf() {
        return left == null;
    }

    /** Half the surface of its box. */
    float area() {
        return BvhBuilder.area(box, 0);
    }
}
