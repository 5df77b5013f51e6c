package org.dronewatch.sensor.acoustic.energy;

import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.OctaveBands;

/** The properties of the air that the energy model uses. */
final class Air {
    private final double[] exponents = new double[OctaveBands.COUNT];
    private final double soundSpeed;

    Air(Atmosphere atmosphere) {
        double[] attenuations = atmosphere.attenuations();
        for (int band = 0; band < exponents.length; band++) {
            // Energy factor exp(-m d) for a loss in dB/m.
            exponents[band] = attenuations[band] * Math.log(10.0) / 10.0;
        }
        this.soundSpeed = atmosphere.speedOfSound();
    }

    /** The fraction of the energy in a band that is left after a distance, m. */
    double left(int band, double distance) {
        return Math.exp(-exponents[band] * distance);
    }

    /** Speed of sound, m/s. */
    double soundSpeed() {
        return soundSpeed;
    }
}
