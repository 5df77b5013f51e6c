package org.dronewatch.render.photo;

import org.dronewatch.geometry.Position;

/**
 * How bright the sky is in each direction, relative to a white, matt, level surface. Its brightness is distributed as
 * that of the standard general skies of ISO 15469:2004 (CIE S 011): type 12, clear, where the sun is known, type 3,
 * overcast and moderately graded, where it is not; scaled so that all of it gives level ground the share of the light that {@link Daylight}
 * says. A clear sky is tinted as light that the air has scattered once: blue high up, white near the horizon, red where
 * the sun is low. Below the horizon it is what air without end would show. Immutable.
 */
final class Sky {
    /** Half the angle that the sun fills, rad. */
    private static final double SUN_RADIUS = Math.toRadians(0.2666);

    /** Radiance of the sun's disc: far beyond what a picture can show. */
    private static final double SUN_DISC = 60.0;

    /** Lowest elevation of a direction, as its sine, that is not the horizon itself. */
    private static final double HORIZON = 0.01;

    /** How far the light of a low sun reddens what it is scattered by: the air mass at which it ends. */
    private static final double REDDEST = 22.0;

    /** Light that was scattered more than once, which is white. */
    private static final double WHITE = 0.06;

    private static final double[] OVERCAST = {0.94, 1.0, 1.05};

    private final Daylight daylight;
    private final boolean clear;
    private final Position sun;
    private final double scale;

    Sky(Daylight daylight) {
        this.daylight = daylight;
        this.clear = daylight.toSun().isPresent();
        this.sun = daylight.toSun().orElse(new Position(0, 0, 1));
        this.scale = daylight.diffuse() / onLevelGround();
    }

    /** The light that a sky of the relative distribution gives level ground, over pi: by the midpoint rule. */
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
        // Of a direction below the horizon, the one above which it lies.
        double up = Math.max(HORIZON, z);
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

    /** Adds the sun where a direction meets its disc. */
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
        return gradation * indicatrix;
    }

    /** The colour of scattered sunlight, of brightness 1. */
    private void tint(double x, double y, double z, double[] rgb) {
        double seen = Daylight.airMass(Math.asin(Math.min(1.0, z)));
        double level = Math.sqrt((x * x + y * y) * (sun.x() * sun.x() + sun.y() * sun.y()));
        double ahead = level > 0.0 ? 0.5 + 0.5 * (x * sun.x() + y * sun.y()) / level : 0.5;
        // High up, the light has come through thinner air; away from the sun, other light prevails.
        double lit = (Math.min(REDDEST, Daylight.airMass(daylight.elevation())) - 1.0)
                * Math.exp(-3.0 * z)
                * (0.25 + 0.75 * ahead * ahead);
        for (int i = 0; i < Daylight.CHANNELS; i++) {
            rgb[i] = (1.0 - Daylight.left(i, seen)) * Daylight.left(i, lit);
        }
        Daylight.equallyBright(rgb);
        for (int i = 0; i < Daylight.CHANNELS; i++) {
            rgb[i] = (1.0 - WHITE) * rgb[i] + WHITE;
        }
    }
}
