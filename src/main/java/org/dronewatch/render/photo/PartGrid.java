package org.dronewatch.render.photo;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.optics.CameraObject;

/**
 * The rays through the centres of the parts into which pixels are divided; with 1 part, those of the pixels. Immutable.
 */
final class PartGrid {
    private final Position from;
    private final double near;
    private final double far;
    private final double[] corner = new double[3];
    private final double[] right = new double[3];
    private final double[] down = new double[3];

    /** @param samples parts of a pixel along each axis */
    PartGrid(CameraObject camera, int samples) {
        this.from = camera.position();
        this.near = camera.near();
        this.far = camera.far();
        double[][] pixels = camera.grid();
        // The step from the centre of the first pixel to that of its first part.
        double back = 0.5 * (1.0 / samples - 1.0);
        for (int i = 0; i < 3; i++) {
            right[i] = pixels[1][i] / samples;
            down[i] = pixels[2][i] / samples;
            corner[i] = pixels[0][i] + back * (pixels[1][i] + pixels[2][i]);
        }
    }

    Position from() {
        return from;
    }

    /** The smallest ray parameter that is seen, m along the axis. */
    double near() {
        return near;
    }

    /** The largest ray parameter that is seen, m along the axis. */
    double far() {
        return far;
    }

    double[] corner() {
        return corner.clone();
    }

    double[] right() {
        return right.clone();
    }

    double[] down() {
        return down.clone();
    }

    /** Writes the unit direction of a part; returns the length that it has in the grid. */
    double direction(int column, int row, double[] target) {
        double square = 0.0;
        for (int i = 0; i < 3; i++) {
            target[i] = corner[i] + column * right[i] + row * down[i];
            square += target[i] * target[i];
        }
        double length = Math.sqrt(square);
        for (int i = 0; i < 3; i++) {
            target[i] /= length;
        }
        return length;
    }
}
