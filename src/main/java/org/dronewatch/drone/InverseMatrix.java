package org.dronewatch.drone;

import org.jogamp.vecmath.Matrix4d;

/** The inverse of a matrix, once it is needed: many drones are placed only to ask where they are. Thread-safe. */
final class InverseMatrix {
    private final Matrix4d matrix;
    private volatile Matrix4d inverse;

    /** The inverse of a matrix that can be inverted, and that does not change. */
    InverseMatrix(Matrix4d matrix) {
        this.matrix = matrix;
    }

    /** The inverse, not to be changed. Threads that need it at once find the same. */
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
