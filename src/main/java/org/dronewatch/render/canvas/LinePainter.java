package org.dronewatch.render.canvas;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.optics.CameraObject;

/**
 * Draws straight lines of the world into a canvas, with soft edges, and only where nothing hides them. Fast enough
 * for a hundred thousand sound rays in a moving view.
 */
public final class LinePainter {
    /** Parts of a line whose depth is less than this are cut off, m. */
    private static final double NEAR = 0.02;

    /** Depth bias, in pixels, because a line may lie on a surface. */
    private static final double FORGIVEN = 2.5;

    private final CameraObject camera;
    private final Cut cut;
    private final Canvas canvas;
    private final double[] from = new double[3];
    private final double[] to = new double[3];
    private int top;
    private int bottom;

    /**
     * A painter of one picture.
     *
     * @param cut clipping plane, or null for none
     */
    public LinePainter(CameraObject camera, Cut cut, Canvas canvas) {
        this.camera = camera;
        this.cut = cut;
        this.canvas = canvas;
        this.bottom = canvas.height;
    }

    /** Restricts what is drawn from now on to the rows from the first, inclusive, to the last, exclusive. */
    public void keepTo(int first, int last) {
        top = first;
        bottom = last;
    }

    /**
     * Draws a line between two points of the world.
     *
     * @param a one end, m
     * @param b the other end, m
     * @param width width of the line, pixels
     * @param colour red, green and blue in the lowest 24 bits
     * @param share opacity of the line, 0 to 1
     */
    public void line(Position a, Position b, double width, int colour, double share) {
        line(a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), width, colour, share);
    }

    /** Draws a line between two points of the world, as {@link #line(Position, Position, double, int, double)}. */
    public void line(
            double ax, double ay, double az, double bx, double by, double bz, double width, int colour, double share) {
        double first = 0.0;
        double last = 1.0;
        if (cut != null) {
            double a = cut.depth(ax, ay, az);
            double b = cut.depth(bx, by, bz);
            if (a > 0.0 && b > 0.0) {
                return;
            }
            first = a > 0.0 ? a / (a - b) : first;
            last = b > 0.0 ? a / (a - b) : last;
        }
        camera.toView(ax + first * (bx - ax), ay + first * (by - ay), az + first * (bz - az), from, 0);
        camera.toView(ax + last * (bx - ax), ay + last * (by - ay), az + last * (bz - az), to, 0);
        if (from[2] < NEAR && to[2] < NEAR) {
            return;
        }
        if (from[2] < NEAR) {
            shorten(from, to);
        } else if (to[2] < NEAR) {
            shorten(to, from);
        }
        double f = camera.focalLength();
        draw(
                0.5 * canvas.width + f * from[0] / from[2],
                0.5 * canvas.height - f * from[1] / from[2],
                1.0 / from[2],
                0.5 * canvas.width + f * to[0] / to[2],
                0.5 * canvas.height - f * to[1] / to[2],
                1.0 / to[2],
                width,
                colour,
                share);
    }

    /** Moves the end that is too near the eye, or behind it, along the line to the least depth that is drawn. */
    private static void shorten(double[] end, double[] other) {
        double share = (NEAR - end[2]) / (other[2] - end[2]);
        end[0] += share * (other[0] - end[0]);
        end[1] += share * (other[1] - end[1]);
        end[2] = NEAR;
    }

    /** Draws a line from pixel to pixel; 1/depth changes evenly along it. */
    private void draw(
            double x0, double y0, double w0, double x1, double y1, double w1, double width, int colour, double share) {
        boolean steep = Math.abs(y1 - y0) > Math.abs(x1 - x0);
        // "Along" is the axis on which the line goes forward by a pixel a step.
        double a0 = steep ? y0 : x0;
        double b0 = steep ? x0 : y0;
        double a1 = steep ? y1 : x1;
        double b1 = steep ? x1 : y1;
        if (a0 > a1) {
            draw(x1, y1, w1, x0, y0, w0, width, colour, share);
            return;
        }
        int firstAlong = steep ? top : 0;
        int lastAlong = (steep ? bottom : canvas.width) - 1;
        int firstAcross = steep ? 0 : top;
        int lastAcross = (steep ? canvas.width : bottom) - 1;
        double span = Math.max(1e-9, a1 - a0);
        double slope = (b1 - b0) / span;
        double half = 0.5 * width * Math.sqrt(1.0 + slope * slope);
        double start = Math.max(firstAlong, Math.round(a0));
        double end = Math.min(lastAlong, Math.round(a1 - 1.0));
        if (Math.abs(slope) > 1e-12) {
            // Only where it is within the picture across its direction, too.
            double one = a0 + (firstAcross - half - 1.0 - b0) / slope;
            double other = a0 + (lastAcross + half + 2.0 - b0) / slope;
            start = Math.max(start, Math.floor(Math.min(one, other)));
            end = Math.min(end, Math.ceil(Math.max(one, other)));
        }
        double forgiven = 1.0 - FORGIVEN / camera.focalLength();
        int stepAcross = steep ? 1 : canvas.width;
        for (int a = (int) start; a <= end; a++) {
            double along = Math.max(0.0, Math.min(1.0, (a + 0.5 - a0) / span));
            double b = b0 + along * (b1 - b0);
            double limit = forgiven / (w0 + along * (w1 - w0));
            int low = (int) Math.max(firstAcross, Math.floor(b - half));
            int high = (int) Math.min(lastAcross, Math.floor(b + half));
            int pixel = steep ? a * canvas.width + low : low * canvas.width + a;
            for (int c = low; c <= high; c++, pixel += stepAcross) {
                if (canvas.depth[pixel] >= limit) {
                    double covered = Math.min(c + 1.0, b + half) - Math.max(c, b - half);
                    canvas.blend(pixel, colour, share * Math.min(1.0, covered));
                }
            }
        }
    }

    /**
     * Whether a point is in the picture, kept by the cut, and nothing hides it.
     *
     * @param size size of the thing at the point, m: a surface that is nearer to the point than this counts as a part
     *     of it
     */
    boolean sees(Position point, double size) {
        if (cut != null && !cut.keeps(point)) {
            return false;
        }
        camera.toView(point.x(), point.y(), point.z(), from, 0);
        if (from[2] < NEAR) {
            return false;
        }
        int column = (int) Math.floor(0.5 * canvas.width + camera.focalLength() * from[0] / from[2]);
        int row = (int) Math.floor(0.5 * canvas.height - camera.focalLength() * from[1] / from[2]);
        return column >= 0
                && row >= 0
                && column < canvas.width
                && row < canvas.height
                && canvas.depth[row * canvas.width + column]
                        >= from[2] * (1.0 - FORGIVEN / camera.focalLength()) - size;
    }
}
