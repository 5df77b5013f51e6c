package org.dronewatch.render.photo;

import java.util.Optional;
import org.dronewatch.geometry.Position;

/**
 * How bright the sky is in each direction, relative to a white, matt, level surface. Its brightness is distributed as
 * that of the standard general skies of ISO 15469:2004 (CIE S 011): type 12, clear, where the sun is known, type 3,
 * overcast and moderately graded, where it is not; scaled so that the whole sky gives level ground the fraction of the
 * light stated by {@link Daylight}. The standard holds for a sun above the horizon; below, type 12 is used all the
 * same. A clear sky has the colours of {@link ScatteredLight}. Below the horizon it is what an infinitely long path
 * through air would show. Immutable.
 */
final class Sky {
    /** Angular radius of the sun, rad. */
    private static final double SUN_RADIUS = Math.toRadians(0.2666);

    /** Radiance of the sun's disc: far more than a picture can show. */
    private static final double SUN_DISC = 60.0;

    /** Sine of the elevation over which the sky changes into what an infinitely long path through air shows. */
    private static final double HORIZON = 0.02;

    private static final double[] OVERCAST = {0.94, 1.0, 1.05};

    private final Daylight daylight;
    private final boolean clear;
    private final Position sun;
    /** The colours of a clear sky. */
    private final Optional<ScatteredLight> scattered;

    private final double scale;

    Sky(Daylight daylight) {
        this.daylight = daylight;
        this.clear = daylight.toSun().isPresent();
        this.sun = daylight.toSun().orElse(new Position(0, 0, 1));
        this.scattered = clear ? Optional.of(new ScatteredLight(daylight.elevation())) : Optional.empty();
        this.scale = daylight.diffuse() / onLevelGround();
    }

    /** Irradiance of level ground by a sky of the relative distribution, over pi, by the midpoint rule. */
    private double onLevelGround() {
        int steps = SkyDirections.STEPS;
        double sum = 0.0;
        for (int i = 0; i < steps; i++) {
            for (int k = 0; k < SkyDirections.AROUND; k++) {
                Position to = SkyDirections.upper(i, k);
                sum += distribution(to.x(), to.y(), to.z()) * to.z() * SkyDirections.SOLID_ANGLE;
            }
        }
        return sum / Math.PI;
    }

    /**
     * Writes the radiance in a direction, without the sun's disc.
     *
     * @param x of a unit vector
     */
    void radiance(double x, double y, double z, double[] rgb) {
        // For a direction below the horizon, one just above it.
        double up = Math.min(1.0, 0.5 * (z + Math.sqrt(z * z + 4.0 * HORIZON * HORIZON)));
        double level = Math.sqrt(Math.max(0.0, 1.0 - up * up) / Math.max(Double.MIN_NORMAL, x * x + y * y));
        double east = level * x;
        double north = level * y;
        double brightness = scale * distribution(east, north, up);
        if (clear) {
            tint(east, north, up, rgb);
        } else {
            System.arraycopy(OVERCAST, 0, rgb, 0, Daylight.CHANNELS);
        }
        for (int i = 0; i < Daylight.CHANNELS; i++) {
            rgb[i] *= brightness;
        }
    }

    /** Adds the sun if a direction hits its disc. */
    void addSun(double x, double y, double z, double[] rgb) {
        if (daylight.isSunny() && x * sun.x() + y * sun.y() + z * sun.z() > Math.cos(SUN_RADIUS)) {
            for (int i = 0; i < Daylight.CHANNELS; i++) {
                rgb[i] += SUN_DISC * daylight.direct(i);
            }
        }
    }

    /** The formula of the standard sky: gradation times indicatrix. */
    private double distribution(double x, double y, double z) {
        if (!clear) {
            return 1.0 + 1.1 * Math.exp(-0.8 / z);
        }
        double gradation = 1.0 - Math.exp(-0.32 / z);
        double cos = Math.max(-1.0, Math.min(1.0, x * sun.x() + y * sun.y() + z * sun.z()));
        double angle = Math.acos(cos);
        double indicatrix = 1.0 + 10.0 * (Math.exp(-3.0 * angle) - Math.exp(-1.5 * Math.PI)) + 0.45 * cos * cos;
        // At night no sun makes one part brighter than another.
        return 1.0 + scattered.orElseThrow().day() * (gradation * indicatrix - 1.0);
    }

    /** The colour of the clear sky, of brightness 1. */
    private void tint(double x, double y, double z, double[] rgb) {
        double level = Math.sqrt((x * x + y * y) * (sun.x() * sun.x() + sun.y() * sun.y()));
        double cosine = level > 0.0 ? (x * sun.x() + y * sun.y()) / level : 0.0;
        scattered.orElseThrow().colour(z, Math.acos(Math.max(-1.0, Math.min(1.0, cosine))), rgb);
    }
}
