package org.dronewatch.kdtree;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.TriangleMesh;

/** Triangles cut to boxes, in double precision, the plain way. */
final class Polygons {

    private Polygons() {}

    /** The corners of the part of a triangle inside a box (six numbers: minimum, maximum); borders belong to it. */
    static List<double[]> clip(TriangleMesh mesh, int triangle, double[] box) {
        List<double[]> polygon = new ArrayList<>();
        for (int corner = 0; corner < 3; corner++) {
            polygon.add(new double[] {
                mesh.coordinate(triangle, corner, 0),
                mesh.coordinate(triangle, corner, 1),
                mesh.coordinate(triangle, corner, 2)
            });
        }
        for (int side = 0; side < 6 && !polygon.isEmpty(); side++) {
            polygon = cut(polygon, side % 3, box[side], side < 3 ? 1.0 : -1.0);
        }
        return polygon;
    }

    private static List<double[]> cut(List<double[]> polygon, int axis, double plane, double side) {
        List<double[]> kept = new ArrayList<>();
        double[] from = polygon.get(polygon.size() - 1);
        for (double[] to : polygon) {
            double here = side * (from[axis] - plane);
            double there = side * (to[axis] - plane);
            if (here * there < 0.0) {
                double[] crossing = new double[3];
                for (int k = 0; k < 3; k++) {
                    crossing[k] = from[k] + here / (here - there) * (to[k] - from[k]);
                }
                crossing[axis] = plane;
                kept.add(crossing);
            }
            if (there >= 0.0) {
                kept.add(to);
            }
            from = to;
        }
        return kept;
    }

    /** Area of a plane polygon. */
    static double area(List<double[]> polygon) {
        double[] sum = new double[3];
        for (int i = 2; i < polygon.size(); i++) {
            double[] a = polygon.get(0);
            double[] b = polygon.get(i - 1);
            double[] c = polygon.get(i);
            for (int k = 0; k < 3; k++) {
                int l = (k + 1) % 3;
                int m = (k + 2) % 3;
                sum[k] += 0.5 * ((b[l] - a[l]) * (c[m] - a[m]) - (b[m] - a[m]) * (c[l] - a[l]));
            }
        }
        return Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    }

    /** The box around a polygon. */
    static double[] bounds(List<double[]> polygon) {
        double[] box = {1, 1, 1, -1, -1, -1};
        for (int axis = 0; axis < 3; axis++) {
            int k = axis;
            box[k] = polygon.stream().mapToDouble(p -> p[k]).min().orElseThrow();
            box[k + 3] = polygon.stream().mapToDouble(p -> p[k]).max().orElseThrow();
        }
        return box;
    }
}
