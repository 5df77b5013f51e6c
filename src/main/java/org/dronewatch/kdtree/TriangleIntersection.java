package org.dronewatch.kdtree;

/**
 * The ray-triangle test of the tracers, after Woop, Benthin and Wald, "Watertight ray/triangle intersection" (JCGT
 * 2013), in double precision. The ray is sheared onto its largest axis; then the three edge functions are
 * two-dimensional and an edge shared by two triangles gets the same value in both but for its sign. A difference of two
 * rounded products never has the wrong sign: at worst it is zero, and zero counts as inside, so that no ray slips
 * through an edge or a corner. By this rule alone, a triangle seen edge-on would also be hit by rays in its plane that
 * miss it: these hits are {@linkplain #isBeside rejected}.
 *
 * <p>Holds one ray and its best hit so far; one per thread.
 */
final class TriangleIntersection {
    private final float[] corners;
    private final int[] numbers;

    private int kx;
    private int ky;
    private int kz;
    private double originX;
    private double originY;
    private double originZ;
    private double shearX;
    private double shearY;
    private double shearZ;

    private double distance;
    private int triangle;
    private double u;
    private double v;
    private boolean found;

    /** A test of a tree's triangles. */
    TriangleIntersection(LeafOrderTriangles triangles) {
        this.corners = triangles.corners();
        this.numbers = triangles.numbers();
    }

    /** Forgets the last hit; one beyond the limit does not count. */
    void begin(double limit) {
        distance = limit;
        found = false;
    }

    /** Sets the ray of the following tests. */
    void setRay(double[] origin, double[] direction) {
        double x = Math.abs(direction[0]);
        double y = Math.abs(direction[1]);
        double z = Math.abs(direction[2]);
        kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        kx = kz == 2 ? 0 : kz + 1;
        ky = kx == 2 ? 0 : kx + 1;
        originX = origin[kx];
        originY = origin[ky];
        originZ = origin[kz];
        shearX = direction[kx] / direction[kz];
        shearY = direction[ky] / direction[kz];
        shearZ = 1.0 / direction[kz];
    }

    /**
     * Tests one triangle and keeps the hit if it is the nearest so far; of several equally near ones, the one with the
     * lowest number.
     *
     * @param index of the triangle in leaf order
     * @param tMin the smallest ray parameter that counts
     */
    void test(int index, double tMin) {
        float[] c = corners;
        int base = 9 * index;

        // Corners relative to the ray: along it (z), and sheared so that the ray becomes the z axis (x, y).
        double az = c[base + kz] - originZ;
        double bz = c[base + 3 + kz] - originZ;
        double cz = c[base + 6 + kz] - originZ;
        double ax = c[base + kx] - originX - shearX * az;
        double ay = c[base + ky] - originY - shearY * az;
        double bx = c[base + 3 + kx] - originX - shearX * bz;
        double by = c[base + 3 + ky] - originY - shearY * bz;
        double cx = c[base + 6 + kx] - originX - shearX * cz;
        double cy = c[base + 6 + ky] - originY - shearY * cz;

        // Edge functions: twice the areas of the triangles between the ray and each edge. All of one sign: inside.
        double a = cx * by - cy * bx;
        double b = ax * cy - ay * cx;
        double g = bx * ay - by * ax;
        if ((a < 0.0 || b < 0.0 || g < 0.0) && (a > 0.0 || b > 0.0 || g > 0.0)) {
            return;
        }
        double determinant = a + b + g;
        if (determinant == 0.0) {
            return;
        }

        // The distance is the mean of the corners', weighted by the edge functions, so it lies between them. Signs are
        // never wrong, so only with a zero can the ray be beside the triangle.
        double t = (a * az + b * bz + g * cz) / determinant * shearZ;
        if (t >= tMin
                && (t < distance || t == distance && (!found || numbers[index] < triangle))
                && !((a == 0.0 || b == 0.0 || g == 0.0) && isBeside(ax, ay, bx, by, cx, cy))) {
            distance = t;
            triangle = numbers[index];
            u = b / determinant;
            v = g / determinant;
            found = true;
        }
    }

    /**
     * Whether a ray misses an edge-on triangle although all edge functions have the same sign, because all corners are
     * on one side of it. Seen edge-on, a triangle has edge functions that are zero or mere rounding errors, along the
     * whole line through its corners.
     *
     * <p>As watertight as the test itself: it is exact for the corners after shearing, which adjacent triangles have in
     * common. A rejected triangle contains no point of the ray, so the triangle that does contain it is another one.
     *
     * @param ax first corner, relative to the ray and sheared, so that the ray is at the origin
     * @param ay first corner
     * @param bx second corner
     * @param by second corner
     * @param cx third corner
     * @param cy third corner
     */
    static boolean isBeside(double ax, double ay, double bx, double by, double cx, double cy) {
        return ax > 0.0 && bx > 0.0 && cx > 0.0
                || ax < 0.0 && bx < 0.0 && cx < 0.0
                || ay > 0.0 && by > 0.0 && cy > 0.0
                || ay < 0.0 && by < 0.0 && cy < 0.0;
    }

    /** Sets a hit that was found elsewhere by the same arithmetic. */
    void setHit(int hitTriangle, double hitDistance) {
        triangle = hitTriangle;
        distance = hitDistance;
        found = true;
    }

    /** Sets the weights of the hit's second and third corner. */
    void setBarycentrics(double hitU, double hitV) {
        u = hitU;
        v = hitV;
    }

    boolean found() {
        return found;
    }

    double distance() {
        return distance;
    }

    int triangle() {
        return triangle;
    }

    double u() {
        return u;
    }

    double v() {
        return v;
    }
}
