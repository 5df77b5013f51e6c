package org.dronewatch.render.canvas;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferInt;
import java.util.Arrays;

/** An unfinished image: colour, depth and triangle of each pixel. For one painter at a time. */
public final class Canvas {
    /** Value of a pixel that shows no triangle of the world. */
    public static final int NOTHING = -1;

    public final int width;
    public final int height;

    /** Red, green and blue in the lowest 24 bits, row by row from the top. */
    public final int[] rgb;

    /** Distance along the camera's axis, m; infinity for the sky. */
    public final float[] depth;

    /** Index of the world's triangle that each pixel shows, or {@link #NOTHING}. */
    public final int[] triangle;

    public Canvas(int width, int height) {
        this.width = width;
        this.height = height;
        this.rgb = new int[width * height];
        this.depth = new float[width * height];
        this.triangle = new int[width * height];
        Arrays.fill(depth, Float.POSITIVE_INFINITY);
        Arrays.fill(triangle, NOTHING);
    }

    /**
     * A copy to draw on. Colours and depths are copied; the triangles, which change only when the world is drawn, are
     * shared.
     */
    public Canvas copy() {
        return new Canvas(this);
    }

    private Canvas(Canvas other) {
        this.width = other.width;
        this.height = other.height;
        this.rgb = other.rgb.clone();
        this.depth = other.depth.clone();
        this.triangle = other.triangle;
    }

    /**
     * Mixes a colour into a pixel.
     *
     * @param pixel index of the pixel in {@link #rgb}
     * @param colour red, green and blue in the lowest 24 bits
     * @param share fraction of the new colour, 0 to 1
     */
    public void blend(int pixel, int colour, double share) {
        rgb[pixel] = mix(rgb[pixel], colour, share);
    }

    /**
     * A colour between two, all with red, green and blue in the lowest 24 bits: the first for a {@code share} of 0, the
     * second for 1.
     */
    public static int mix(int below, int above, double share) {
        int weight = (int) (share * 256.0 + 0.5);
        int r = (below >> 16 & 255) * (256 - weight) + (above >> 16 & 255) * weight >> 8;
        int g = (below >> 8 & 255) * (256 - weight) + (above >> 8 & 255) * weight >> 8;
        int b = (below & 255) * (256 - weight) + (above & 255) * weight >> 8;
        return r << 16 | g << 8 | b;
    }

    /**
     * The picture, each of whose pixels is the mean of a square of pixels of this canvas.
     *
     * @param samples pixels of this canvas along a side of the square
     */
    public BufferedImage toImage(int samples) {
        BufferedImage image = new BufferedImage(width / samples, height / samples, BufferedImage.TYPE_INT_RGB);
        int[] target = ((DataBufferInt) image.getRaster().getDataBuffer()).getData();
        if (samples == 1) {
            System.arraycopy(rgb, 0, target, 0, rgb.length);
            return image;
        }
        int columns = image.getWidth();
        int all = samples * samples;
        for (int i = 0; i < target.length; i++) {
            int first = i / columns * samples * width + i % columns * samples;
            int r = 0;
            int g = 0;
            int b = 0;
            for (int y = 0; y < samples; y++) {
                for (int x = 0; x < samples; x++) {
                    int colour = rgb[first + y * width + x];
                    r += colour >> 16 & 255;
                    g += colour >> 8 & 255;
                    b += colour & 255;
                }
            }
            target[i] = r / all << 16 | g / all << 8 | b / all;
        }
        return image;
    }

    /**
     * This canvas at a smaller size: colours are means; depths and triangles are those of the pixel with the least
     * depth.
     */
    public Canvas shrunk(int columns, int rows) {
        int samples = width / columns;
        Canvas small = new Canvas(columns, rows);
        int[] colours = ((DataBufferInt) toImage(samples).getRaster().getDataBuffer()).getData();
        System.arraycopy(colours, 0, small.rgb, 0, small.rgb.length);
        for (int i = 0; i < small.depth.length; i++) {
            int first = i / columns * samples * width + i % columns * samples;
            for (int k = 0; k < samples * samples; k++) {
                int pixel = first + k / samples * width + k % samples;
                if (depth[pixel] < small.depth[i]) {
                    small.depth[i] = depth[pixel];
                    small.triangle[i] = triangle[pixel];
                }
            }
        }
        return small;
    }
}
