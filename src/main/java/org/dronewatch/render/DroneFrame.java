package org.dronewatch.render;

import java.awt.Rectangle;
import java.awt.geom.Rectangle2D;
import org.dronewatch.sensor.optics.DronePixels;

/** The frame around a drone's pixels in a camera's picture. */
public final class DroneFrame {
    /** Margin between the significant pixels and the frame, in the camera's pixels. */
    private static final int MARGIN = 1;

    /** Distance from the edge of the picture, so that the whole line is inside. */
    private static final double INSET = 1.0;

    private DroneFrame() {}

    /**
     * A frame around the significant pixels, inside the picture even when the drone is at the edge of the picture.
     *
     * @param width pixels in a row of the camera's image
     * @param height rows of the camera's image
     * @param picture rectangle in which the whole image is drawn
     * @param smallest minimum side length of the frame, in pixels of the picture, so that a distant drone can be found
     */
    public static Rectangle2D.Double about(
            DronePixels drone, int width, int height, Rectangle picture, double smallest) {
        double sx = picture.width / (double) width;
        double sy = picture.height / (double) height;
        double wide = side((drone.columns() + 2 * MARGIN) * sx, smallest, picture.width);
        double high = side((drone.rows() + 2 * MARGIN) * sy, smallest, picture.height);
        double x = corner((drone.left() + 0.5 * drone.columns()) * sx, wide, picture.width);
        double y = corner((drone.top() + 0.5 * drone.rows()) * sy, high, picture.height);
        return new Rectangle2D.Double(picture.x + x, picture.y + y, wide, high);
    }

    private static double side(double wanted, double smallest, double whole) {
        return Math.min(Math.max(smallest, wanted), Math.max(0.0, whole - 2.0 * INSET));
    }

    private static double corner(double middle, double side, double whole) {
        return Math.max(INSET, Math.min(whole - INSET - side, middle - 0.5 * side));
    }
}
