package org.dronewatch.render.photo;

import java.util.Optional;
import org.dronewatch.geometry.Position;

/**
 * How bright the sky is in each direction, relative to a white, matt, level surface. A clear sky has the radiance of
 * {@link ScatteredLight}; where the sun is not known, the sky is type 3 of ISO 15469:2004 (CIE S 011), overcast and
 * moderately graded. Both are scaled so that the whole sky gives level ground the fraction of the light stated by
 * {@link Daylight}. Immutable.
 */
final class Sky {
    /** Angular radius of the sun, rad. */
    private static final double SUN_RADIUS = Math.toRadians(0.2666);

    /** Radiance of the sun's disc: far more than a picture can show. */
    private static final double SUN_DISC = 60.0;

    private static final double[] OVERCAST = {0.94, 1.0, 1.05};

    private final Daylight daylight;
    private final Position sun;

    /** The scattered light of a clear sky. */
    private final Optional<ScatteredLight> scattered;

    private final double scale;

    Sky(Daylight daylight) {
        this.daylight = daylight;
        this.sun = daylight.toSun().orElse(new Position(0, 0, 1));
        this.scattered = daylight.toSun().map(toSun -> new ScatteredLight(daylight.elevation()));
        this.scale = daylight.diffuse() / onLevelGround();
    }

    /** Irradiance of level ground by the sky before it is scaled, over pi, by the midpoint rule. */
    private double onLevelGround() {
        double[] rgb = new double[Daylight.CHANNELS];
        double sum = 0.0;
        for (int i = 0; i < SkyDirections.STEPS; i++) {
            for (int k = 0; k < SkyDirections.AROUND; k++) {
                Position to = SkyDirections.upper(i, k);
                unscaled(to.x(), to.y(), to.z(), rgb);
                sum += Daylight.brightness(rgb) * to.z() * SkyDirections.SOLID_ANGLE;
            }
        }
        return sum / Math.PI;
    }

    /**
     * Writes the radiance in a direction, without the sun's disc; below the horizon, that at the horizon.
     *
     * @param x x of a unit vector
     */
    void radiance(double x, double y, double z, double[] rgb) {
        unscaled(x, y, Math.max(0.0, z), rgb);
        for (int i = 0; i < Daylight.CHANNELS; i++) {
            rgb[i] *= scale;
        }
    }

    private void unscaled(double x, double y, double up, double[] rgb) {
        if (scattered.isEmpty()) {
            double brightness = 1.0 + 1.1 * Math.exp(-0.8 / Math.max(Double.MIN_NORMAL, up));
            for (int i = 0; i < Daylight.CHANNELS; i++) {
                rgb[i] = brightness * OVERCAST[i];
            }
            return;
        }
        double around = Math.sqrt(sun.x() * sun.x() + sun.y() * sun.y());
        double product = Math.sqrt(x * x + y * y) * around;
        double along = product > 0.0 ? Math.max(-1.0, Math.min(1.0, (x * sun.x() + y * sun.y()) / product)) : 1.0;
        double level = Math.sqrt(Math.max(0.0, 1.0 - up * up));
        double cosine = Math.max(-1.0, Math.min(1.0, level * around * along + up * sun.z()));
        scattered.get().radiance(up, Math.acos(along), cosine, rgb);
    }

    /** Adds the sun if a direction hits its disc. */
    void addSun(double x, double y, double z, double[] rgb) {
        if (daylight.isSunny() && x * sun.x() + y * sun.y() + z * sun.z() > Math.cos(SUN_RADIUS)) {
            for (int i = 0; i < Daylight.CHANNELS; i++) {
                rgb[i] += SUN_DISC * daylight.direct(i);
            }
        }
    }
}
