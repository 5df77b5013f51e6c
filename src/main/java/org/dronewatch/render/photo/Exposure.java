package org.dronewatch.render.photo;

/**
 * From light to the numbers of a picture. The logarithmic mean of what is seen becomes a middle tone, as by a camera's
 * automatic exposure (Reinhard et al., "Photographic tone reproduction for digital images", SIGGRAPH 2002), but in poor
 * light a darker one. What is too bright fades to white instead of being cut off: {@code 1 - exp(-k x)}, and then the
 * transfer function of sRGB (IEC 61966-2-1). Immutable.
 */
final class Exposure {
    /** In less light than this, pictures get darker, lx. */
    private static final double AMPLE = 1000.0;

    private static final double DARKER = 0.15;

    /** The middle tone, of the largest one. */
    private static final double MIDDLE = 0.32;

    /** Limits of what cameras can do: snow in sunshine is bright, a dark room is dark. */
    private static final double LEAST = 0.3;

    private static final double MOST = 6.0;

    private final double gain;

    /**
     * For a picture.
     *
     * @param mean logarithmic mean of its brightness, relative to a white, matt, level surface
     * @param illuminance of level ground, lx
     */
    Exposure(double mean, double illuminance) {
        double metered = -Math.log(1.0 - MIDDLE) / mean;
        this.gain = Math.max(LEAST, Math.min(MOST, metered)) * Math.min(1.0, Math.pow(illuminance / AMPLE, DARKER));
    }

    /** The pixel for a radiance of three channels: red, green and blue in the lowest 24 bits. */
    int pixel(double red, double green, double blue) {
        return level(red) << 16 | level(green) << 8 | level(blue);
    }

    private int level(double radiance) {
        return (int) Math.round(255.0 * encoded(1.0 - Math.exp(-gain * Math.max(0.0, radiance))));
    }

    private static double encoded(double linear) {
        return linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1.0 / 2.4) - 0.055;
    }

    /** The fraction of the light that a surface reflects whose colour on a screen is this, 0 to 255. */
    static double decoded(int level) {
        double share = level / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }
}
