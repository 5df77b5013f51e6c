package org.dronewatch.render.photo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.dronewatch.world.Light;
import org.junit.jupiter.api.Test;

/** The colours of a clear sky from noon to night, and how they come into a picture. */
class SkyColourTest {
    private static final int RED = 0;
    private static final int BLUE = 2;

    private static double[] colour(double elevation, double upDegrees, double azimuthDegrees) {
        double[] rgb = new double[3];
        new ScatteredLight(Math.toRadians(elevation))
                .colour(Math.sin(Math.toRadians(upDegrees)), Math.toRadians(azimuthDegrees), rgb);
        return rgb;
    }

    private static double redness(double[] rgb) {
        return rgb[RED] / rgb[BLUE];
    }

    @Test
    void theZenithIsBlueByDayAndWhereTheSunHasJustSet() {
        assertThat(redness(colour(50, 90, 0))).isLessThan(0.6);
        // Without ozone it would be yellow (Hulburt 1953).
        assertThat(redness(colour(-3, 90, 0))).isLessThan(0.75);
    }

    @Test
    void theHorizonReddensTowardsALowSunAndNotAtNoon() {
        double noon = redness(colour(60, 2, 0));
        assertThat(noon).isBetween(0.7, 1.6);
        assertThat(redness(colour(5, 2, 0))).isGreaterThan(1.5 * noon);
        assertThat(redness(colour(-2, 2, 0))).isGreaterThan(4.0 * noon);
    }

    /** Twilight ends at 18 degrees below the horizon: then no colour is left of the sun. */
    @Test
    void theNightHasNoSunset() {
        double[] towards = colour(-20, 2, 0);
        double[] away = colour(-20, 60, 180);
        assertThat(redness(towards)).isCloseTo(redness(away), within(0.02));
        assertThat(redness(towards)).isLessThan(1.0);
        assertThat(new ScatteredLight(Math.toRadians(-20)).day()).isLessThan(0.01);
        assertThat(new ScatteredLight(0).day()).isGreaterThan(0.999);
    }

    /** Half a degree of the sun, or of the line of sight, changes colours little: there are no steps. */
    @Test
    void coloursChangeSmoothly() {
        for (double elevation = 10; elevation > -18; elevation -= 0.5) {
            double[] here = colour(elevation, 5, 30);
            double[] next = colour(elevation - 0.5, 5, 30);
            for (int i = 0; i < 3; i++) {
                assertThat(next[i]).as("sun at %f", elevation).isCloseTo(here[i], within(0.15 + 0.25 * here[i]));
            }
        }
        Sky dusk = new Sky(new Daylight(Light.DAY.withSun(new Light.Sun(Math.toRadians(90), Math.toRadians(2)))));
        int steps = 140;
        double[][] sky = new double[steps][3];
        for (int step = 0; step < steps; step++) {
            double up = Math.toRadians(-5 + 0.25 * step);
            dusk.radiance(0, Math.cos(up), Math.sin(up), sky[step]);
        }
        for (int step = 2; step < steps - 1; step++) {
            for (int i = 0; i < 3; i++) {
                double beside = Math.max(
                        Math.abs(sky[step - 1][i] - sky[step - 2][i]), Math.abs(sky[step + 1][i] - sky[step][i]));
                assertThat(Math.abs(sky[step][i] - sky[step - 1][i]))
                        .as("%f degrees up", -5 + 0.25 * step)
                        .isLessThan(2.0 * beside + 0.002);
            }
        }
    }

    /** Over an even area, the pattern of numbers has the mean of what lies between them. */
    @Test
    void anEvenSkyHasNoBands() {
        Exposure exposure = new Exposure(1.0, 1e5);
        double last = 0;
        for (double radiance = 0.5; radiance < 0.52; radiance += 0.0005) {
            double sum = 0;
            int least = 255;
            int most = 0;
            for (int row = 0; row < 8; row++) {
                for (int column = 0; column < 8; column++) {
                    int blue = exposure.pixel(radiance, radiance, radiance, column, row) & 0xFF;
                    sum += blue / 64.0;
                    least = Math.min(least, blue);
                    most = Math.max(most, blue);
                }
            }
            assertThat(most - least).isLessThanOrEqualTo(1);
            if (last > 0) {
                assertThat(sum - last).as("%f", radiance).isBetween(0.02, 0.2);
            }
            last = sum;
        }
    }

    /** The mean of the 8 x 8 pattern is the exact value, within the half step of its 64 thresholds. */
    @Test
    void theMeanOfThePatternIsTheExactValue() {
        Exposure exposure = new Exposure(1.0, 1e5);
        double gain = -Math.log(1.0 - 0.32);
        for (double radiance = 0.001; radiance < 8.0; radiance *= 1.01) {
            double linear = 1.0 - Math.exp(-gain * radiance);
            double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * Math.pow(linear, 1.0 / 2.4) - 0.055;
            double sum = 0.0;
            for (int row = 0; row < 8; row++) {
                for (int column = 0; column < 8; column++) {
                    sum += exposure.pixel(radiance, radiance, radiance, column, row) & 0xFF;
                }
            }
            assertThat(sum / 64.0).as("%f", radiance).isCloseTo(255.0 * encoded, within(1.0 / 128.0 + 1e-9));
        }
    }

    /** The hue stays as light gets brighter, and ends in white. */
    @Test
    void brightColoursFadeToWhite() {
        Exposure exposure = new Exposure(1.0, 1e5);
        assertThat(exposure.pixel(1e6, 2e5, 1e5, 3, 3)).isEqualTo(0xFFFFFF);
        assertThat(exposure.pixel(0, 0, 0, 3, 3)).isZero();
        int dim = exposure.pixel(0.4, 0.2, 0.1, 0, 0);
        assertThat(dim >> 16 & 0xFF).isGreaterThan(dim >> 8 & 0xFF);
        assertThat(dim >> 8 & 0xFF).isGreaterThan(dim & 0xFF);
    }
}
