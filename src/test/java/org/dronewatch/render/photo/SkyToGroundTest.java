package org.dronewatch.render.photo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.world.Light;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** How many times brighter than matt ground the sky at the horizon is: the figures of the camera page. */
class SkyToGroundTest {
    private static double horizon(Light light) {
        double[] rgb = new double[Daylight.CHANNELS];
        // At right angles to the sun, which is in the north.
        new Sky(new Daylight(light)).radiance(1, 0, 0, rgb);
        return Daylight.brightness(rgb);
    }

    @ParameterizedTest
    @CsvSource({
        "20, 0.8, 0.49", "20, 0.3, 1.3", "20, 0.2, 1.96", "20, 0.05, 7.8",
        "40, 0.8, 0.34", "40, 0.3, 0.90", "40, 0.2, 1.35", "40, 0.05, 5.4"
    })
    void underAClearSkyItDependsOnTheSun(double elevation, double albedo, double ratio) {
        Light sunny = Light.DAY.withIlluminance(50_000).withSun(new Light.Sun(0, Math.toRadians(elevation)));

        assertThat(horizon(sunny) / albedo).isCloseTo(ratio, within(0.02 * ratio));
    }

    /**
     * ISO 15469, type 3: 1 at the horizon; the illuminance over pi is the integral of (1 + 1.1 exp(-0.8/u)) 2u over u
     * from 0 to 1.
     */
    @ParameterizedTest
    @CsvSource({"0.8, 0.95", "0.3, 2.5", "0.2, 3.8", "0.05, 15.2"})
    void underCloudsTheSkyIsBrighter(double albedo, double ratio) {
        int steps = 100_000;
        double ground = 0.0;
        for (int i = 0; i < steps; i++) {
            double up = (i + 0.5) / steps;
            ground += (1.0 + 1.1 * Math.exp(-0.8 / up)) * 2.0 * up / steps;
        }

        assertThat(horizon(Light.DAY) / albedo).isCloseTo(ratio, within(0.02 * ratio));
        assertThat(1.0 / ground / albedo).isCloseTo(ratio, within(0.02 * ratio));
    }
}
