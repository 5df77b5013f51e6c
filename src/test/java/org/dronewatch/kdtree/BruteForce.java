package org.dronewatch.kdtree;

import java.math.BigDecimal;
import java.math.MathContext;
import org.dronewatch.geometry.TriangleMesh;

/**
 * Tests every triangle, after Möller and Trumbore, in double precision; where a decision hangs on rounding it is made
 * again in exact decimals. Independent of the kernel. Rays are six numbers: origin, direction.
 */
public final class BruteForce {
    /** Weights nearer to their limits, and determinants nearer to zero, relatively, are computed exactly. */
    private static final double DOUBTFUL = 1e-9;

    private final double[] corners;
    private final int count;

    public BruteForce(TriangleMesh mesh) {
        this.count = mesh.triangleCount();
        this.corners = new double[9 * count];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = mesh.coordinate(i / 9, i / 3 % 3, i % 3);
        }
    }

    /** The nearest hit. */
    public Answer closest(double[] ray) {
        return closest(ray, 0.0, Double.POSITIVE_INFINITY);
    }

    /** The nearest hit between two ray parameters. */
    public Answer closest(double[] ray, double tMin, double tMax) {
        double best = Double.POSITIVE_INFINITY;
        int triangle = -1;
        for (int i = 0; i < count; i++) {
            double t = hit(ray, i);
            if (t >= tMin && t <= tMax && t < best) {
                best = t;
                triangle = i;
            }
        }
        return new Answer(best, triangle);
    }

    /** Parameter of the ray's crossing of a triangle; not a number if there is none, negative behind the origin. */
    public double hit(double[] r, int triangle) {
        double[] c = corners;
        int k = 9 * triangle;
        double bx = c[k + 3] - c[k];
        double by = c[k + 4] - c[k + 1];
        double bz = c[k + 5] - c[k + 2];
        double cx = c[k + 6] - c[k];
        double cy = c[k + 7] - c[k + 1];
        double cz = c[k + 8] - c[k + 2];
        double px = r[4] * cz - r[5] * cy;
        double py = r[5] * cx - r[3] * cz;
        double pz = r[3] * cy - r[4] * cx;
        double determinant = bx * px + by * py + bz * pz;
        double size = Math.abs(bx) + Math.abs(by) + Math.abs(bz);
        size *= (Math.abs(cx) + Math.abs(cy) + Math.abs(cz)) * (Math.abs(r[3]) + Math.abs(r[4]) + Math.abs(r[5]));
        if (Math.abs(determinant) <= DOUBTFUL * size) {
            return exactHit(r, triangle);
        }

        double ox = r[0] - c[k];
        double oy = r[1] - c[k + 1];
        double oz = r[2] - c[k + 2];
        double u = (ox * px + oy * py + oz * pz) / determinant;
        double qx = oy * bz - oz * by;
        double qy = oz * bx - ox * bz;
        double qz = ox * by - oy * bx;
        double v = (r[3] * qx + r[4] * qy + r[5] * qz) / determinant;
        double least = Math.min(Math.min(u, v), 1.0 - u - v);
        if (Math.abs(least) < DOUBTFUL) {
            return exactHit(r, triangle);
        }
        return least < 0.0 ? Double.NaN : (cx * qx + cy * qy + cz * qz) / determinant;
    }

    private double exactHit(double[] r, int triangle) {
        BigDecimal[] direction = {exact(r[3]), exact(r[4]), exact(r[5])};
        BigDecimal[] edgeB = new BigDecimal[3];
        BigDecimal[] edgeC = new BigDecimal[3];
        BigDecimal[] fromA = new BigDecimal[3];
        for (int axis = 0; axis < 3; axis++) {
            BigDecimal a = exact(corners[9 * triangle + axis]);
            edgeB[axis] = exact(corners[9 * triangle + 3 + axis]).subtract(a);
            edgeC[axis] = exact(corners[9 * triangle + 6 + axis]).subtract(a);
            fromA[axis] = exact(r[axis]).subtract(a);
        }
        BigDecimal[] p = cross(direction, edgeC);
        BigDecimal[] q = cross(fromA, edgeB);
        BigDecimal determinant = dot(edgeB, p);
        BigDecimal sign = exact(determinant.signum());
        BigDecimal u = dot(fromA, p).multiply(sign);
        BigDecimal v = dot(direction, q).multiply(sign);
        if (sign.signum() == 0 || u.signum() < 0 || v.signum() < 0 || u.add(v).compareTo(determinant.abs()) > 0) {
            return Double.NaN;
        }
        return dot(edgeC, q).divide(determinant, MathContext.DECIMAL64).doubleValue();
    }

    private static BigDecimal exact(double number) {
        return new BigDecimal(number);
    }

    private static BigDecimal[] cross(BigDecimal[] a, BigDecimal[] b) {
        BigDecimal[] result = new BigDecimal[3];
        for (int i = 0; i < 3; i++) {
            int j = (i + 1) % 3;
            int k = (i + 2) % 3;
            result[i] = a[j].multiply(b[k]).subtract(a[k].multiply(b[j]));
        }
        return result;
    }

    private static BigDecimal dot(BigDecimal[] a, BigDecimal[] b) {
        return a[0].multiply(b[0]).add(a[1].multiply(b[1])).add(a[2].multiply(b[2]));
    }

    /** How near the ray's line comes to an edge of a triangle. */
    public double edgeDistance(double[] ray, int triangle) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < 3; i++) {
            double[] start = acrossRay(ray, 9 * triangle + 3 * i);
            double[] end = acrossRay(ray, 9 * triangle + 3 * ((i + 1) % 3));
            double[] edge = {end[0] - start[0], end[1] - start[1], end[2] - start[2]};
            double squared = dot(edge, edge);
            double s = squared > 0.0 ? Math.min(1.0, Math.max(0.0, -dot(start, edge) / squared)) : 0.0;
            double[] nearest = {start[0] + s * edge[0], start[1] + s * edge[1], start[2] + s * edge[2]};
            least = Math.min(least, Math.sqrt(dot(nearest, nearest)));
        }
        return least;
    }

    /** A corner as seen along the ray: its offset from the ray's line. */
    private double[] acrossRay(double[] r, int corner) {
        double[] direction = {r[3], r[4], r[5]};
        double[] w = {corners[corner] - r[0], corners[corner + 1] - r[1], corners[corner + 2] - r[2]};
        double along = dot(w, direction) / dot(direction, direction);
        return new double[] {w[0] - along * r[3], w[1] - along * r[4], w[2] - along * r[5]};
    }

    private static double dot(double[] a, double[] b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    }

    /**
     * What a ray hits.
     *
     * @param distance ray parameter, infinity for none
     * @param triangle number of the triangle, -1 for none
     */
    public record Answer(double distance, int triangle) {
        boolean found() {
            return triangle >= 0;
        }
    }
}
