package org.dronewatch.render.photo;

import org.dronewatch.geometry.Position;

/** Directions spread evenly over the hemisphere above the horizon, for sums over the sky. */
final class SkyDirections {
    /** Bands of equal solid angle from the horizon to the zenith. */
    static final int STEPS = 48;

    /** Directions in each band. */
    static final int AROUND = 96;

    /** Solid angle that each direction represents, sr. */
    static final double SOLID_ANGLE = 2.0 * Math.PI / (STEPS * AROUND);

    private SkyDirections() {}

    /** A unit vector. */
    static Position upper(int step, int around) {
        double z = (step + 0.5) / STEPS;
        double level = Math.sqrt(1.0 - z * z);
        double azimuth = 2.0 * Math.PI * (around + 0.5) / AROUND;
        return new Position(level * Math.sin(azimuth), level * Math.cos(azimuth), z);
    }
}
