package org.dronewatch.raster;

import java.util.SplittableRandom;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;

/** A picture through a pinhole, to test tiles with. */
public final class PinholeView {
    public final double[] from;
    public final double[] corner;
    public final double[] right;
    public final double[] down;

    public PinholeView(double[] from, double[] corner, double[] right, double[] down) {
        this.from = from;
        this.corner = corner;
        this.right = right;
        this.down = down;
    }

    /** Somewhere in or about the mesh, looking anywhere; every third along an axis. */
    public static PinholeView random(TriangleMesh mesh, SplittableRandom random, int number, int width) {
        AABB box = mesh.triangleCount() == 0 ? new AABB(-1, -1, -1, 1, 1, 1) : mesh.bounds();
        Point3d middle = box.center();
        double reach = number % 2 == 0 ? 0.5 : 1.5;
        PinholeView view = new PinholeView(new double[3], new double[3], new double[3], new double[3]);
        view.from[0] = middle.x + reach * (2 * random.nextDouble() - 1) * (box.maxX() - box.minX());
        view.from[1] = middle.y + reach * (2 * random.nextDouble() - 1) * (box.maxY() - box.minY());
        view.from[2] = middle.z + reach * (2 * random.nextDouble() - 1) * (box.maxZ() - box.minZ());
        Vector3d forward =
                new Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, random.nextDouble() - 0.5);
        if (number % 4 == 1) {
            // From outside at least look at it.
            forward.set(middle.x - view.from[0], middle.y - view.from[1], middle.z - view.from[2]);
        }
        Vector3d top = new Vector3d(0, 0, 1);
        if (number % 3 == 0) {
            int axis = random.nextInt(3);
            forward.set(axis == 0 ? 1 : 0, axis == 1 ? 1 : 0, axis == 2 ? -1 : 0);
            top.set(axis == 0 ? 0 : 1, axis == 0 ? 1 : 0, 0);
            if (number % 2 == 0 && mesh.triangleCount() > 0) {
                // At the height of a vertex: in the plane of whatever lies level with it.
                view.from[2] = mesh.coordinate(random.nextInt(mesh.triangleCount()), 0, 2);
            }
        }
        forward.normalize();
        Vector3d u = new Vector3d();
        u.cross(forward, top);
        u.normalize();
        Vector3d v = new Vector3d();
        v.cross(forward, u);
        double step = (0.1 + 2.0 * random.nextDouble()) / width;
        int height = 3 * width / 4;
        // An even number of pixels has no middle one: half of the axis-parallel views get a ray along the axis.
        double offset = number % 2 == 0 ? 0.0 : 0.5;
        for (int k = 0; k < 3; k++) {
            double[] f = {forward.x, forward.y, forward.z};
            double[] a = {u.x, u.y, u.z};
            double[] b = {v.x, v.y, v.z};
            view.right[k] = step * a[k];
            view.down[k] = step * b[k];
            view.corner[k] = f[k] - (width / 2 - offset) * step * a[k] - (height / 2 - offset) * step * b[k];
        }
        return view;
    }

    public double[] ray(int column, int row) {
        double[] ray = new double[6];
        for (int k = 0; k < 3; k++) {
            ray[k] = from[k];
            ray[3 + k] = corner[k] + column * right[k] + row * down[k];
        }
        return ray;
    }
}
