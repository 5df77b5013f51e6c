package org.dronewatch.render.photo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Light;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The colours of a clear sky from noon to night, and how they come into a picture. */
class SkyColourTest {
    private static final int RED = 0;
    private static final int BLUE = 2;

    private static double[] colour(double elevation, double upDegrees, double azimuthDegrees) {
        return colour(new ScatteredLight(Math.toRadians(elevation)), elevation, upDegrees, azimuthDegrees);
    }

    private static double[] colour(ScatteredLight light, double elevation, double upDegrees, double azimuthDegrees) {
        double up = Math.toRadians(upDegrees);
        double azimuth = Math.toRadians(azimuthDegrees);
        double sun = Math.toRadians(elevation);
        double cosine = Math.cos(up) * Math.cos(sun) * Math.cos(azimuth) + Math.sin(up) * Math.sin(sun);
        double[] rgb = new double[3];
        light.radiance(Math.sin(up), azimuth, cosine, rgb);
        return rgb;
    }

    private static double redness(double[] rgb) {
        return rgb[RED] / rgb[BLUE];
    }

    private static double zenith(double elevation) {
        return Daylight.brightness(colour(elevation, 90, 0));
    }

    /** Illuminance of level ground by the sky, lx, with 127.5 klx outside the air. */
    private static double illuminance(double elevation) {
        ScatteredLight light = new ScatteredLight(Math.toRadians(elevation));
        double sum = 0;
        for (int i = 0; i < 48; i++) {
            double z = (i + 0.5) / 48;
            for (int k = 0; k < 48; k++) {
                double[] rgb = colour(light, elevation, Math.toDegrees(Math.asin(z)), 180.0 * (k + 0.5) / 48);
                sum += Daylight.brightness(rgb) * z * 2 * Math.PI / (48 * 48);
            }
        }
        return 127_500 * sum;
    }

    /** Level ground has 0.8 + 15.5 sqrt(sin h) klx from a clear sky (IESNA Lighting Handbook, 9th ed., ch. 8). */
    @ParameterizedTest
    @CsvSource({"90, 0.1", "60, 0.1", "40, 0.1", "20, 0.1", "10, 0.2", "0, 0.2"})
    void theSkyIsAsBrightAsMeasuredSkiesByDay(double elevation, double tolerance) {
        double measured = 800 + 15_500 * Math.sqrt(Math.sin(Math.toRadians(elevation)));
        assertThat(illuminance(elevation)).isCloseTo(measured, within(tolerance * measured));
    }

    /**
     * Illuminance by twilight: 410 to 585 lx when the sun has just set, 2 to 3.5 at -6, 0.008 at -12, 0.0006 lx at
     * -18 degrees (American Meteorological Society, Glossary of Meteorology; for the last three, {@code ClearSky} has
     * 3.4, 0.008 and 0.00065). Nothing was fitted to it: 17 degrees darken the ground by six powers of ten; the
     * factor allowed at -12 is 2.
     */
    @ParameterizedTest
    @CsvSource({"-0.833, 410, 585", "-6, 1.6, 5.5", "-12, 0.004, 0.016", "-18, 0.0005, 0.0009"})
    void theSkyIsAsBrightAsMeasuredSkiesInTwilight(double elevation, double least, double most) {
        assertThat(illuminance(elevation)).isBetween(least, most);
    }

    /**
     * At a fixed exposure the zenith darkens in every colour as the sun sinks, without a step, to the light of the
     * night.
     */
    @Thorough
    @Test
    void theZenithDarkensFromDayToNight() {
        double[] last = colour(10.25, 90, 0);
        for (double elevation = 10; elevation >= -18; elevation -= 0.25) {
            double[] here = colour(elevation, 90, 0);
            for (int i = 0; i < 3; i++) {
                assertThat(here[i] / last[i]).as("sun at %f", elevation).isBetween(0.6, 1.0);
            }
            last = here;
        }
        // 22 magnitudes per square second of arc, over the sun's 127.5 klx.
        assertThat(zenith(-20)).isCloseTo(1.7e-4 / 127_500, within(0.05 * 1.7e-4 / 127_500));
        // More than a magnitude from -12 to -18 degrees (Patat and others 2006, of the zenith in V).
        assertThat(zenith(-12)).isGreaterThan(2.5 * zenith(-18));
    }

    @Test
    void theZenithIsBlueByDayAndWhereTheSunHasJustSet() {
        assertThat(redness(colour(50, 90, 0))).isLessThan(0.6);
        // Without ozone it would be yellow (Hulburt 1953).
        assertThat(redness(colour(-3, 90, 0))).isLessThan(0.6);
        assertThat(redness(colour(-6, 90, 0))).isLessThan(0.4);
    }

    @Test
    void theHorizonReddensTowardsALowSunAndNotAtNoon() {
        double noon = redness(colour(60, 2, 0));
        assertThat(noon).isBetween(0.7, 1.2);
        assertThat(redness(colour(5, 2, 0))).isGreaterThan(2.0 * noon);
        assertThat(redness(colour(0, 2, 0))).isGreaterThan(4.0 * noon);
    }

    /** Twilight ends at 18 degrees below the horizon: then little colour is left of the sun. */
    @Test
    void theNightHasNoSunset() {
        double[] towards = colour(-20, 2, 0);
        double[] away = colour(-20, 60, 180);
        assertThat(redness(towards)).isCloseTo(redness(away), within(0.05));
        assertThat(Daylight.brightness(towards)).isCloseTo(Daylight.brightness(away), within(1e-10));
    }

    /**
     * The whole dome in the picture's numbers, 0 to 255, from noon to night, along 25 lines from the horizon to the
     * zenith, in steps from 0.001 degrees at the horizon to 0.6, and along 19 around the sky: a step of an edge would
     * be much larger than those beside it.
     */
    @ParameterizedTest
    @ValueSource(doubles = {60, 30, 10, 5, 2, 0, -1, -2, -3, -4.5, -6, -7.5, -9, -10.5, -12, -13.5, -15, -16.5, -18})
    void theWholeDomeIsSmooth(double elevation) {
        Light light = Light.DAY.withSun(new Light.Sun(0, Math.toRadians(elevation)));
        Sky sky = new Sky(new Daylight(light));
        double[] rgb = new double[3];
        double[] brightness = new double[36 * 18];
        for (int i = 0; i < brightness.length; i++) {
            look(sky, 2.5 + 5 * (i % 18), 2.5 + 5 * (i / 18), rgb);
            brightness[i] = Daylight.brightness(rgb);
        }
        Exposure exposure = Exposure.of(brightness, 1e5);
        for (double along = 0; along <= 180; along += 7.5) {
            int[][] line = new int[301][3];
            for (int i = 0; i < line.length; i++) {
                look(sky, 90.0 * i * i / 90_000, along, rgb);
                line[i] = shown(exposure, rgb);
            }
            check(line, elevation + " upwards at " + along);
        }
        for (double up = 0; up <= 90; up += 5) {
            int[][] line = new int[361][3];
            for (int i = 0; i < line.length; i++) {
                look(sky, up, 0.5 * i, rgb);
                line[i] = shown(exposure, rgb);
            }
            check(line, elevation + " around at " + up);
        }
    }

    private static int[] shown(Exposure exposure, double[] rgb) {
        int pixel = exposure.pixel(rgb[0], rgb[1], rgb[2], 0, 0);
        return new int[] {pixel >> 16 & 0xFF, pixel >> 8 & 0xFF, pixel & 0xFF};
    }

    /** Numbers are whole: two steps may differ by one or two for that alone. */
    private static void check(int[][] line, String where) {
        for (int i = 2; i < line.length - 1; i++) {
            for (int channel = 0; channel < 3; channel++) {
                int step = Math.abs(line[i][channel] - line[i - 1][channel]);
                int before = Math.abs(line[i - 1][channel] - line[i - 2][channel]);
                int after = Math.abs(line[i + 1][channel] - line[i][channel]);
                assertThat(step).as("%s: %d", where, i).isLessThanOrEqualTo((int) (1.5 * Math.max(before, after)) + 2);
            }
        }
    }

    private static void look(Sky sky, double upDegrees, double azimuthDegrees, double[] rgb) {
        double up = Math.toRadians(upDegrees);
        double azimuth = Math.toRadians(azimuthDegrees);
        sky.radiance(Math.cos(up) * Math.sin(azimuth), Math.cos(up) * Math.cos(azimuth), Math.sin(up), rgb);
    }

    /**
     * Ground beyond the model comes out of the haze of the horizon without an edge, and further down has the mean
     * colour of the site as seen from above: here a fourth of it is red, what faces down and what stands upright does
     * not count.
     */
    @ParameterizedTest
    @ValueSource(doubles = {60, 10, 0, -6, -12, -18})
    void theGroundComesOutOfTheHazeOfTheHorizon(double elevation) {
        Light light = Light.DAY.withSun(new Light.Sun(0, Math.toRadians(elevation)));
        float[] points = {0, 0, 0, 3, 0, 0, 0, 2, 0, -1, 0, 0, 0, 0, 9};
        TriangleMesh mesh = new TriangleMesh(
                points,
                new int[] {0, 1, 2, 0, 2, 3, 0, 2, 1, 0, 1, 4},
                new int[] {0, 1, 2, 2},
                new int[] {1, 2, 3, 4},
                List.of("grass", "brick", "blue"));
        Surfaces surfaces = new Surfaces(mesh, Map.of("grass", 0x66883c, "brick", 0xb04030, "blue", 0x0000ff));
        SceneLight scene = SceneLight.of(World.of(mesh).withLight(light), surfaces);
        Position eye = new Position(0, 0, 30);
        double[] horizon = backdrop(scene, eye, 0);
        double[] below = backdrop(scene, eye, -0.02);
        double[] near = backdrop(scene, eye, -60);
        double[] ground = {
            0.75 * decoded(0x66) + 0.25 * decoded(0xb0),
            0.75 * decoded(0x88) + 0.25 * decoded(0x40),
            0.75 * decoded(0x3c) + 0.25 * decoded(0x30)
        };
        double[] white = backdrop(SceneLight.of(World.of(mesh).withLight(light), white(mesh)), eye, -60);
        for (int i = 0; i < 3; i++) {
            // Without the haze of 30 m / sin 60 degrees of air, of which both have the same.
            double haze = horizon[i] * (1 - Math.pow(0.05, 30 / Math.sin(Math.toRadians(60)) / 20_000));
            assertThat((near[i] - haze) / (white[i] - haze)).isCloseTo(ground[i], within(1e-9));
        }
        for (int i = 0; i < 3; i++) {
            assertThat(below[i]).isCloseTo(horizon[i], within(0.02 * horizon[i]));
            double share = (backdrop(scene, eye, -1)[i] - near[i]) / (horizon[i] - near[i]);
            // Of 30 m / sin 1 degree of air with 5 % contrast at 20 km.
            assertThat(share).isCloseTo(1 - Math.pow(0.05, 30 / Math.sin(Math.toRadians(1)) / 20_000), within(0.02));
        }
    }

    /** IEC 61966-2-1. */
    private static double decoded(int value) {
        return value / 255.0 <= 0.04045 ? value / 255.0 / 12.92 : Math.pow((value / 255.0 + 0.055) / 1.055, 2.4);
    }

    private static Surfaces white(TriangleMesh mesh) {
        return new Surfaces(mesh, Map.of("grass", 0xffffff, "brick", 0xffffff, "blue", 0xffffff));
    }

    /** A site that shows only its undersides, and an empty one, stand on ordinary ground. */
    @Test
    void groundThatNobodySeesFromAboveIsOrdinary() {
        float[] points = {0, 0, 0, 3, 0, 0, 0, 2, 0};
        for (int[] corners : new int[][] {{0, 2, 1}, {}}) {
            TriangleMesh mesh = TriangleMesh.of(points, corners);
            assertThat(new Surfaces(mesh, Map.of()).fromAbove()).isEmpty();
            SceneLight scene = SceneLight.of(World.of(mesh), new Surfaces(mesh, Map.of()));
            assertThat(Daylight.brightness(backdrop(scene, new Position(0, 0, 30), -60)))
                    .isCloseTo(AmbientLight.ALBEDO, within(0.1 * AmbientLight.ALBEDO + 0.01));
        }
    }

    private static double[] backdrop(SceneLight scene, Position eye, double upDegrees) {
        double up = Math.toRadians(upDegrees);
        double[] rgb = new double[3];
        scene.backdrop(eye.z(), new double[] {Math.cos(up), 0, Math.sin(up)}, rgb, new double[3]);
        return rgb;
    }

    /** Over an even area, the pattern of numbers has the mean of what lies between them. */
    @Test
    void anEvenSkyHasNoBands() {
        Exposure exposure = new Exposure(1.0, 1.0, 1e5);
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
        Exposure exposure = new Exposure(1.0, 1.0, 1e5);
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

    /** A glow that much of the picture consists of darkens it, by at most 45 %; a few bright pixels do not. */
    @Test
    void aGlowIsSparedAtTheExpenseOfTheRest() {
        double[] even = new double[100];
        Arrays.fill(even, 0.1);
        double[] spot = even.clone();
        Arrays.fill(spot, 0, 4, 1e2);
        double[] glow = even.clone();
        Arrays.fill(glow, 0, 10, 1e2);
        double share = 1 - 0.32;
        // The logarithmic means are 10^0.12 and 10^0.3 times that of the even picture; a tenth of the light of an even
        // picture is shown without a
        // limit.
        assertThat(linear(Exposure.of(even, 1e5), 0.01)).isCloseTo(1 - Math.pow(share, 0.1), within(0.002));
        double spotted = 1 - Math.pow(share, 0.1 / Math.pow(10, 0.12));
        assertThat(linear(Exposure.of(spot, 1e5), 0.01)).isCloseTo(spotted, within(0.002));
        double spared = 1 - Math.pow(share, 0.55 * 0.1 / Math.pow(10, 0.3));
        assertThat(linear(Exposure.of(glow, 1e5), 0.01)).isCloseTo(spared, within(0.002));
    }

    private static double linear(Exposure exposure, double radiance) {
        return Exposure.decoded(exposure.pixel(radiance, radiance, radiance, 0, 0) & 0xFF);
    }

    /** The hue stays as light gets brighter, and ends in white. */
    @Test
    void brightColoursFadeToWhite() {
        Exposure exposure = new Exposure(1.0, 1.0, 1e5);
        assertThat(exposure.pixel(1e6, 2e5, 1e5, 3, 3)).isEqualTo(0xFFFFFF);
        assertThat(exposure.pixel(0, 0, 0, 3, 3)).isZero();
        int dim = exposure.pixel(0.4, 0.2, 0.1, 0, 0);
        assertThat(dim >> 16 & 0xFF).isGreaterThan(dim >> 8 & 0xFF);
        assertThat(dim >> 8 & 0xFF).isGreaterThan(dim & 0xFF);
    }
}
