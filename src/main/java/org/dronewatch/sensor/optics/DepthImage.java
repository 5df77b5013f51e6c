package org.dronewatch.sensor.optics;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import javax.imageio.ImageIO;

/** A camera's image as distances in metres, infinity for the sky, and the pixels that show drones. Immutable. */
public final class DepthImage {
    private static final int SKY = 0xfff6e8;
    private static final int HIT = 0xff6a00;
    /** Distance shown in the darkest blue, m: the logarithm of 0 is infinite. */
    private static final double NEAREST_SHADE = 1e-3;

    private static final int[] NEAR_BLUE = {6, 20, 64};
    private static final int[] FAR_BLUE = {206, 228, 250};

    private final int width;
    private final int height;
    private final float[] distances;
    private final boolean[] hits;

    /**
     * An image from its pixels, row by row from the top; copies the arrays.
     *
     * @param distances distance along each pixel's ray, m; infinity where it hits nothing
     * @param hits whether each pixel shows a drone
     * @throws IllegalArgumentException if the arrays do not have width times height elements
     */
    public DepthImage(int width, int height, float[] distances, boolean[] hits) {
        if (width <= 0 || height <= 0 || distances.length != width * height || hits.length != distances.length) {
            throw new IllegalArgumentException("image of " + width + " x " + height + " pixels with " + distances.length
                    + " distances and " + hits.length + " hit flags");
        }
        this.width = width;
        this.height = height;
        this.distances = distances.clone();
        this.hits = hits.clone();
    }

    private DepthImage(CameraObject camera, float[] distances, boolean[] hits) {
        this.width = camera.width();
        this.height = camera.height();
        this.distances = distances;
        this.hits = hits;
    }

    /** A camera's image from arrays that are no longer modified. */
    static DepthImage over(CameraObject camera, float[] distances, boolean[] hits) {
        return new DepthImage(camera, distances, hits);
    }

    /** The number of pixels per row. */
    public int width() {
        return width;
    }

    /** The number of rows. */
    public int height() {
        return height;
    }

    /** Distance along a pixel's ray, m; infinity where it hits nothing. */
    public float distance(int column, int row) {
        return distances[row * width + column];
    }

    /** Whether a pixel shows a drone. */
    public boolean isHit(int column, int row) {
        return hits[row * width + column];
    }

    /** The number of pixels that show a drone. */
    public int hitCount() {
        int count = 0;
        for (boolean hit : hits) {
            count += hit ? 1 : 0;
        }
        return count;
    }

    /**
     * The image in shades of blue on a logarithmic scale, darker for shorter distances; the sky is pale and drones are
     * orange.
     */
    public BufferedImage toImage() {
        double nearest = Double.POSITIVE_INFINITY;
        double farthest = 0.0;
        for (float distance : distances) {
            if (distance < Float.POSITIVE_INFINITY) {
                nearest = Math.min(nearest, Math.max(distance, NEAREST_SHADE));
                farthest = Math.max(farthest, distance);
            }
        }
        double span = farthest > nearest ? Math.log(farthest / nearest) : 1.0;
        BufferedImage image = new BufferedImage(width, height, BufferedImage.TYPE_INT_RGB);
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int pixel = row * width + column;
                double fraction = Math.log(Math.max(distances[pixel], NEAREST_SHADE) / nearest) / span;
                image.setRGB(column, row, hits[pixel] ? HIT : colour(distances[pixel], fraction));
            }
        }
        return image;
    }

    private static int colour(float distance, double fraction) {
        if (distance == Float.POSITIVE_INFINITY) {
            return SKY;
        }
        int rgb = 0;
        for (int channel = 0; channel < 3; channel++) {
            double value = NEAR_BLUE[channel] + fraction * (FAR_BLUE[channel] - NEAR_BLUE[channel]);
            rgb = rgb << 8 | (int) Math.round(value);
        }
        return rgb;
    }

    /** Writes the image as a PNG. */
    public void writePng(OutputStream target) throws IOException {
        ImageIO.write(toImage(), "png", target);
    }

    /** Writes the distances as a Portable Float Map: rows from bottom to top, little endian, infinity for the sky. */
    public void writePfm(OutputStream target) throws IOException {
        target.write(("Pf\n" + width + " " + height + "\n-1.0\n").getBytes(StandardCharsets.US_ASCII));
        ByteBuffer buffer = ByteBuffer.allocate(Float.BYTES * width).order(ByteOrder.LITTLE_ENDIAN);
        for (int row = height - 1; row >= 0; row--) {
            buffer.clear();
            buffer.asFloatBuffer().put(distances, row * width, width);
            target.write(buffer.array());
        }
    }
}
