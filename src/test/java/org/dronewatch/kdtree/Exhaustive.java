package org.dronewatch.kdtree;

/** The kernel's own triangle test on every triangle: what a traversal must find, to the last bit. */
final class Exhaustive {
    private final int triangles;
    private final TriangleIntersection intersection;

    Exhaustive(KDTree tree) {
        this.triangles = tree.mesh().triangleCount();
        this.intersection = new TriangleIntersection(tree.triangles());
    }

    /** Distance of the nearest hit between two ray parameters; infinity for none. */
    double closest(double[] r, double tMin, double tMax) {
        intersection.begin(tMax);
        intersection.setRay(new double[] {r[0], r[1], r[2]}, new double[] {r[3], r[4], r[5]});
        for (int i = 0; i < triangles; i++) {
            intersection.test(i, tMin);
        }
        return intersection.found() ? intersection.distance() : Double.POSITIVE_INFINITY;
    }
}
