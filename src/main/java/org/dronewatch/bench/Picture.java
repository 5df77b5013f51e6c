package org.dronewatch.bench;

import org.jogamp.vecmath.Matrix3d;
import org.jogamp.vecmath.SingularMatrixException;
import org.jogamp.vecmath.Vector3d;

/**
 * The pinhole picture that a set of rays is declared to form: found from the rays of its four corners, checked against
 * every ray. Tiles whose rays are not those of the picture are identified.
 */
final class Picture {
    /** How far a given direction may deviate from the picture's: a few rounding errors of a unit vector of floats. */
    private static final double TOLERANCE = 3e-7;

    private final RaySet set;
    private final int width;
    private final int height;
    private final double[] corner = new double[3];
    private final double[] right = new double[3];
    private final double[] down = new double[3];
    private final boolean found;

    /** Looks for the picture of a set that has a width. */
    Picture(RaySet set) {
        this.set = set;
        this.width = set.width();
        this.height = set.count() / width;
        this.found = width > 1 && height > 1 && find();
    }

    /**
     * The four corners of a picture lie in one plane and make a parallelogram there: the one at the bottom right is the
     * sum of its neighbours minus the one across, for the right lengths of the four.
     */
    private boolean find() {
        Vector3d a = direction(0, 0);
        Vector3d b = direction(width - 1, 0);
        Vector3d c = direction(0, height - 1);
        Vector3d d = direction(width - 1, height - 1);
        Matrix3d matrix = new Matrix3d(b.x, c.x, -d.x, b.y, c.y, -d.y, b.z, c.z, -d.z);
        try {
            matrix.invert();
        } catch (SingularMatrixException e) {
            return false;
        }
        Vector3d lengths = new Vector3d();
        matrix.transform(a, lengths);
        b.scale(lengths.x);
        c.scale(lengths.y);
        b.sub(a);
        c.sub(a);
        b.scale(1.0 / (width - 1));
        c.scale(1.0 / (height - 1));
        a.get(corner);
        b.get(right);
        c.get(down);
        return true;
    }

    private Vector3d direction(int column, int row) {
        int i = RaySet.FLOATS * (row * width + column);
        float[] r = set.rays();
        return new Vector3d(r[i + 3], r[i + 4], r[i + 5]);
    }

    /** Whether the rays of a tile are those of the picture, from the picture's origin. */
    boolean holds(int left, int top, int columns, int rows) {
        for (int row = top; row < top + rows && found; row++) {
            for (int column = left; column < left + columns; column++) {
                if (!isOf(column, row)) {
                    return false;
                }
            }
        }
        return found;
    }

    private boolean isOf(int column, int row) {
        float[] r = set.rays();
        int i = RaySet.FLOATS * (row * width + column);
        Vector3d given = direction(column, row);
        Vector3d ours = new Vector3d(
                corner[0] + column * right[0] + row * down[0],
                corner[1] + column * right[1] + row * down[1],
                corner[2] + column * right[2] + row * down[2]);
        ours.scale(given.length() / ours.length());
        ours.sub(given);
        return ours.length() <= TOLERANCE * given.length() && r[i] == r[0] && r[i + 1] == r[1] && r[i + 2] == r[2];
    }

    int width() {
        return width;
    }

    int height() {
        return height;
    }

    /** Where all rays start. */
    double[] origin() {
        float[] r = set.rays();
        return new double[] {r[0], r[1], r[2]};
    }

    /** Direction of the first pixel. */
    double[] corner() {
        return corner.clone();
    }

    /** The vector that each column adds to the direction. */
    double[] right() {
        return right.clone();
    }

    /** The vector that each row adds to the direction. */
    double[] down() {
        return down.clone();
    }
}
