package org.dronewatch.render.photo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.function.DoubleFunction;
import org.assertj.core.data.Offset;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.ClearSky;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The radiance of a clear sky from noon to night, and how it comes into a picture. */
class SkyColourTest {
    private static final int RED = 0;
    private static final int BLUE = 2;

    private static double[] radiance(ScatteredLight sky, double upDegrees, double azimuthDegrees) {
        double[] rgb = new double[3];
        sky.radiance(Math.sin(Math.toRadians(upDegrees)), Math.toRadians(azimuthDegrees), rgb);
        return rgb;
    }

    private static double[] colour(double elevation, double upDegrees, double azimuthDegrees) {
        return radiance(new ScatteredLight(Math.toRadians(elevation)), upDegrees, azimuthDegrees);
    }

    private static double redness(double[] rgb) {
        return rgb[RED] / rgb[BLUE];
    }

    /** Illuminance of level ground by the sky alone, lx. */
    private static double illuminance(double elevation) {
        ScatteredLight sky = new ScatteredLight(Math.toRadians(elevation));
        double[] rgb = new double[3];
        double sum = 0.0;
        for (int i = 0; i < SkyDirections.STEPS; i++) {
            for (int k = 0; k < SkyDirections.AROUND; k++) {
                Position to = SkyDirections.upper(i, k);
                sky.radiance(to.z(), Math.abs(Math.atan2(to.y(), to.x())), rgb);
                sum += Daylight.brightness(rgb) * to.z() * SkyDirections.SOLID_ANGLE;
            }
        }
        return ScatteredLight.SUN_OUTSIDE * sum;
    }

    @Test
    void theZenithIsBlueByDayAndWhereTheSunHasJustSet() {
        assertThat(redness(colour(50, 90, 0))).isLessThan(0.6);
        // Without ozone it would be yellow (Hulburt 1953).
        assertThat(redness(colour(-3, 90, 0))).isLessThan(0.5);
    }

    @Test
    void theHorizonReddensTowardsALowSunAndNotAtNoon() {
        double noon = redness(colour(60, 2, 0));
        assertThat(noon).isBetween(0.7, 1.6);
        assertThat(redness(colour(5, 2, 0))).isGreaterThan(1.5 * noon);
        assertThat(redness(colour(-2, 2, 0))).isGreaterThan(3.5 * noon);
    }

    /** Twilight ends at 18 degrees below the horizon: then no light is left of the sun. */
    @Test
    void theNightHasNoSunset() {
        double[] towards = colour(-20, 2, 0);
        double[] away = colour(-20, 60, 180);
        assertThat(redness(towards)).isCloseTo(redness(away), within(0.02));
        assertThat(redness(towards)).isLessThan(1.0);
        assertThat(Daylight.brightness(towards)).isCloseTo(Daylight.brightness(away), within(1e-10));
    }

    /** Nothing is fitted to these: 3.4, 0.008 and 0.00065 lx at the ends of the twilights (Seidelmann 1992). */
    @ParameterizedTest
    @CsvSource({"-6, 3.4, 1.8", "-12, 0.008, 1.8", "-18, 0.00065, 1.3"})
    void twilightsEndAtTheIlluminancesOfAstronomers(double elevation, double lux, double factor) {
        assertThat(illuminance(elevation)).isBetween(lux / factor, lux * factor);
        assertThat(ClearSky.illuminance(Math.toRadians(elevation))).isCloseTo(lux, within(1e-9 * lux));
    }

    /** The air here is clearer than that of the average clear sky of IESNA: by day it has a third less light. */
    @Test
    void byDayTheSkyGivesTheLightOfAClearOne() {
        for (double elevation : new double[] {10, 30, 60}) {
            double average = ClearSky.diffuse(Math.toRadians(elevation));
            assertThat(illuminance(elevation)).as("sun at %s", elevation).isBetween(0.6 * average, 1.1 * average);
        }
    }

    @Test
    void theZenithDarkensAsTheSunSets() {
        double last = Double.POSITIVE_INFINITY;
        for (double elevation = 10; elevation >= -18; elevation -= 0.5) {
            double zenith = Daylight.brightness(colour(elevation, 90, 0));
            assertThat(zenith).as("sun at %s", elevation).isLessThan(last);
            last = zenith;
        }
    }

    /** The amount of air to the sun is the air mass of Kasten and Young, but for refraction at the horizon. */
    @ParameterizedTest
    @CsvSource({"90, 0.003", "45, 0.003", "20, 0.005", "10, 0.01", "5, 0.03", "2, 0.08"})
    void theAirToTheSunIsTheAirMass(double elevation, double tolerance) {
        double up = Math.sin(Math.toRadians(elevation));
        AirDepth depth = new AirDepth();
        assertThat(depth.toSun(0.0, up, 400)).isTrue();
        double exact = depth.air();
        assertThat(exact).isCloseTo(ClearSky.airMass(Math.toRadians(elevation)), withinShare(tolerance, exact));
        assertThat(depth.toSun(0.0, up, 16)).isTrue();
        assertThat(depth.air()).as("in as few steps as the sky's").isCloseTo(exact, withinShare(0.02, exact));
        assertThat(depth.toSun(10.0, -Math.sin(Math.toRadians(4)), 16))
                .as("the earth in between")
                .isFalse();
    }

    private static Offset<Double> withinShare(double share, double of) {
        return within(share * of);
    }

    /**
     * All over the dome, from noon to night: between directions a quarter of a degree apart, what a picture shows changes by no
     * more than at the neighbouring steps (and a level of 255), so there is no edge, neither of the earth's shadow nor of the table's cells.
     */
    @ParameterizedTest
    @ValueSource(doubles = {60, 20, 5, 0, -3, -6, -9, -12, -15, -18})
    void thereIsNoEdgeInTheSky(double elevation) {
        ScatteredLight sky = new ScatteredLight(Math.toRadians(elevation));
        double mean = Daylight.brightness(radiance(sky, 30, 90));
        for (double azimuth = 0; azimuth <= 180; azimuth += 7.5) {
            double fixed = azimuth;
            assertSmooth(elevation, mean, 0.5, 89.5, up -> radiance(sky, up, fixed));
        }
        for (double up : new double[] {0, 1, 2, 5, 10, 30, 60}) {
            assertSmooth(elevation, mean, 0.5, 179.5, azimuth -> radiance(sky, up, azimuth));
        }
    }

    private static void assertSmooth(
            double elevation, double mean, double from, double to, DoubleFunction<double[]> line) {
        double step = 0.25;
        double[] shown = new double[4];
        int count = 0;
        for (double place = from; place <= to; place += step) {
            System.arraycopy(shown, 1, shown, 0, 3);
            // Brightness as in Exposure, with the middle of the sky as a middle tone, in 255 levels.
            double light = Daylight.brightness(line.apply(place)) / mean;
            shown[3] = 255.0 * Math.pow(1.0 - Math.exp(-0.39 * light), 1.0 / 2.2);
            count++;
            if (count >= 4) {
                double change = Math.abs(shown[2] - shown[1]);
                double beside = Math.max(Math.abs(shown[1] - shown[0]), Math.abs(shown[3] - shown[2]));
                assertThat(change)
                        .as("sun at %s, %s degrees along the line", elevation, place)
                        .isLessThan(1.5 * beside + 1.0);
                assertThat(change).as("sun at %s, %s degrees", elevation, place).isLessThan(12.0);
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
