package org.dronewatch.drone;

import org.jogamp.vecmath.Matrix4d;

/**
 * The inverse of a matrix, computed when it is first needed: many drones are placed only to find their positions.
 * Thread-safe.
 */
final class InverseMatrix {
    private final Matrix4d matrix;
    private volatile Matrix4d inverse;

    /** The inverse of a matrix that can be inverted, and that does not change. */
    InverseMatrix(Matrix4d matrix) {
        this.matrix = matrix;
    }

    /** The inverse, which must not be changed. Threads that need it at the same time get equal results. */
    Matrix4d get() {
        Matrix4d known = inverse;
        if (known == null) {
            known = new Matrix4d();
            known.invert(matrix);
            inverse = known;
        }
        return known;
    }
}
