package org.dronewatch.render.photo;

import java.util.Arrays;

/**
 * Converts light to the numbers of a picture. The logarithmic mean of what is seen becomes a middle tone, as by a
 * camera's automatic exposure (Reinhard et al., "Photographic tone reproduction for digital images", SIGGRAPH 2002),
 * but a darker one in poor light, and where much of the picture, such as the glow of a low sun, would be white.
 * Excessive brightness fades to white instead of being clipped: brightness is {@code 1 - exp(-k x)}, followed by the
 * transfer function of sRGB (IEC 61966-2-1). Immutable.
 */
final class Exposure {
    /** In less light than this, lx, pictures are darker. */
    private static final double AMPLE = 1000.0;

    private static final double DARKER = 0.15;

    /** The middle tone, as a fraction of the largest value. */
    private static final double MIDDLE = 0.32;

    /** Limits of automatic exposure: snow in sunshine stays bright, a dark room stays dark. */
    private static final double LEAST = 0.3;

    private static final double MOST = 6.0;

    /**
     * The greatest exponent for the brightest twentieth, which thus keeps its colour, at the price of a darker picture.
     */
    private static final double BRIGHT = 1.6;

    /** The least fraction to which a picture may be darkened for that. */
    private static final double SPARED = 0.55;

    private static final int[][] BAYER = bayer();

    private final double gain;

    /**
     * The exposure of a picture.
     *
     * @param mean logarithmic mean of its brightness, relative to a white, matt, level surface
     * @param bright brightness that only the brightest twentieth of the picture exceeds
     * @param illuminance of level ground, lx
     */
    Exposure(double mean, double bright, double illuminance) {
        double metered = -Math.log(1.0 - MIDDLE) / mean;
        double spared = Math.max(SPARED, Math.min(1.0, BRIGHT / (metered * bright)));
        this.gain = Math.max(LEAST, Math.min(MOST, metered * spared))
                * Math.min(1.0, Math.pow(illuminance / AMPLE, DARKER));
    }

    /**
     * The exposure of a picture.
     *
     * @param brightness brightness, above 0, at places spread evenly over the picture; the array is sorted
     * @param illuminance of level ground, lx
     */
    static Exposure of(double[] brightness, double illuminance) {
        Arrays.sort(brightness);
        double sum = 0.0;
        for (double place : brightness) {
            sum += Math.log(place);
        }
        double bright = brightness[(int) (0.95 * (brightness.length - 1))];
        return new Exposure(Math.exp(sum / brightness.length), bright, illuminance);
    }

    /**
     * The pixel for a radiance of three channels: red, green and blue in the lowest 24 bits. Hue is kept as it gets
     * brighter, and fades to white where it would be brighter than a screen can show. Values between two levels are
     * dithered with a fixed pattern (Bayer, ICC 1973), so that a smooth sky shows no bands.
     */
    int pixel(double red, double green, double blue, int column, int row) {
        double brightness = Daylight.brightness(red, green, blue);
        if (!(brightness > 0.0)) {
            return 0;
        }
        double shown = 1.0 - Math.exp(-gain * brightness);
        double brightest = Math.max(red, Math.max(green, blue)) / brightness * shown;
        double colourful = colourful(brightest - shown, 1.0 - shown);
        double threshold = (BAYER[row & 7][column & 7] + 0.5) / 64.0;
        double factor = colourful * shown / brightness;
        double white = (1.0 - colourful) * shown;
        return level(white + factor * red, threshold) << 16
                | level(white + factor * green, threshold) << 8
                | level(white + factor * blue, threshold);
    }

    /**
     * The fraction of its colour that a pixel keeps, so that no channel is brighter than a screen can show, without a
     * step where one would be.
     *
     * @param over by how much the brightest channel exceeds the pixel's brightness
     * @param room by how much a screen's greatest brightness exceeds the pixel's brightness
     */
    private static double colourful(double over, double room) {
        if (over <= 0.0) {
            return 1.0;
        }
        return room > 0.0 ? -Math.expm1(-over / room) * room / over : 0.0;
    }

    private static int level(double linear, double threshold) {
        return (int) Math.min(255.0, Math.floor(255.0 * encoded(Math.max(0.0, linear)) + threshold));
    }

    /** The 8 x 8 matrix of all thresholds from 0 to 63, each as far as possible from those next in order. */
    private static int[][] bayer() {
        int[][] matrix = new int[8][8];
        for (int row = 0; row < 8; row++) {
            for (int column = 0; column < 8; column++) {
                for (int bit = 0; bit < 3; bit++) {
                    int across = column >> bit & 1;
                    int down = row >> bit & 1;
                    matrix[row][column] |= (2 * (across ^ down) + down) << 2 * (2 - bit);
                }
            }
        }
        return matrix;
    }

    private static double encoded(double linear) {
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1.0 / 2.4) - 0.055;
    }

    /** The fraction of the light that is reflected by a surface whose colour has this level on a screen, 0 to 255. */
    static double decoded(int level) {
        double share = level / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }
}
