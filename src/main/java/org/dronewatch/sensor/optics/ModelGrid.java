package org.dronewatch.sensor.optics;

import org.dronewatch.geometry.Position;
import org.dronewatch.raster.TileTracer;
import org.jogamp.vecmath.Matrix4d;

/**
 * The rays of a camera's pixels in the space of a model. Lengths along them remain those of the world. Reused for
 * several models; for use by one thread.
 */
public final class ModelGrid {
    private final double[][] grid;
    private final Position from;
    private final double near;
    private final double far;
    private final double[] origin = new double[3];
    private final double[][] modelGrid = new double[3][3];

    /** The grid of the pixels of a camera. */
    public ModelGrid(CameraObject camera) {
        this.grid = camera.grid();
        this.from = camera.position();
        this.near = camera.near();
        this.far = camera.far();
    }

    /**
     * Sets up a traversal of a model's tree for the camera's image.
     *
     * @param m the matrix from the world to the model's space
     */
    public void setPicture(TileTracer traversal, Matrix4d m) {
        origin[0] = m.m00 * from.x() + m.m01 * from.y() + m.m02 * from.z() + m.m03;
        origin[1] = m.m10 * from.x() + m.m11 * from.y() + m.m12 * from.z() + m.m13;
        origin[2] = m.m20 * from.x() + m.m21 * from.y() + m.m22 * from.z() + m.m23;
        for (int i = 0; i < grid.length; i++) {
            double[] d = grid[i];
            modelGrid[i][0] = m.m00 * d[0] + m.m01 * d[1] + m.m02 * d[2];
            modelGrid[i][1] = m.m10 * d[0] + m.m11 * d[1] + m.m12 * d[2];
            modelGrid[i][2] = m.m20 * d[0] + m.m21 * d[1] + m.m22 * d[2];
        }
        traversal.setPicture(origin, modelGrid[0], modelGrid[1], modelGrid[2], near, far);
    }
}
