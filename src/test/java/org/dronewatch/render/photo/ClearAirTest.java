package org.dronewatch.render.photo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import java.util.function.ToDoubleFunction;
import org.dronewatch.world.ClearSky;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Light on its way through the air, against closed forms, and a table of air masses. */
class ClearAirTest {
    private static double column(double height, double up, int steps, ToDoubleFunction<AirPath> density) {
        AirPath path = new AirPath();
        path.start(height, up, steps);
        double sum = 0;
        while (path.next()) {
            sum += path.length() * density.applyAsDouble(path);
        }
        return sum;
    }

    /**
     * Haze is exponential: towards the horizon sqrt(pi x / 2) (1 + 3 / (8 x)) columns, x = radius / scale height
     * (Chapman 1931).
     */
    @Test
    void theColumnTowardsTheHorizonIsChapmans() {
        double closed = chapman(0);
        assertThat(column(0, 0, 32, AirPath::haze)).isCloseTo(closed, within(0.01 * closed));
        assertThat(column(0, 0, 2000, AirPath::haze)).isCloseTo(closed, within(1e-4 * closed));
        assertThat(column(0, 1, 2000, AirPath::haze)).isCloseTo(1.0, within(1e-3));
        assertThat(column(0, 1, 32, AirPath::air)).isCloseTo(1.0, within(0.005));
        assertThat(column(0, 1, 32, AirPath::ozone)).isCloseTo(1.0, within(0.01));
        // From a height, past a lowest point 2 km up: from there twice Chapman's column, but for what lies outside.
        double height = 8;
        double up = -Math.sqrt(1 - Math.pow((ClearAir.EARTH + 2) / (ClearAir.EARTH + height), 2));
        double outside = column(height, -up, 2000, AirPath::haze);
        double past = 2 * chapman(2) - outside;
        assertThat(column(height, up, 2000, AirPath::haze)).isCloseTo(past, within(1e-3 * past));
        assertThat(column(height, up, 32, AirPath::haze)).isCloseTo(past, within(0.03 * past));
    }

    private static double chapman(double height) {
        double x = (ClearAir.EARTH + height) / ClearAir.HAZE_SCALE;
        return Math.exp(-height / ClearAir.HAZE_SCALE) * Math.sqrt(0.5 * Math.PI * x) * (1 + 3 / (8 * x));
    }

    /** The air masses of Kasten and Young (1989), which include refraction: it matters near the horizon only. */
    @ParameterizedTest
    @ValueSource(doubles = {90, 60, 30, 20, 10})
    void columnsAreTheAirMasses(double elevation) {
        double mass = ClearSky.airMass(Math.toRadians(elevation));
        assertThat(column(0, Math.sin(Math.toRadians(elevation)), 32, AirPath::air))
                .isCloseTo(mass, within(0.01 * mass));
    }

    /** The table against the path itself in many steps. */
    @Test
    void sunlightIsLostByTheDepthOfThePath() {
        Random random = new Random(7);
        AirPath path = new AirPath();
        double[] rgb = new double[3];
        for (int i = 0; i < 300; i++) {
            double height = ClearAir.TOP * Math.pow(random.nextDouble(), 2);
            double horizon = ClearAir.horizon(height);
            double up = horizon + 1e-6 + (1 - horizon) * Math.pow(random.nextDouble(), 3) * 0.999;
            SunInAir.write(height, up, rgb);
            path.start(height, up, 2000);
            double[] depth = new double[3];
            while (path.next()) {
                for (int channel = 0; channel < 3; channel++) {
                    depth[channel] += path.depth(channel);
                }
            }
            for (int channel = 0; channel < 3; channel++) {
                assertThat(rgb[channel])
                        .as("seed 7: %f km, %f", height, up)
                        .isCloseTo(Math.exp(-depth[channel]), within(0.02));
            }
        }
        SunInAir.write(20, ClearAir.horizon(20) - 1e-6, rgb);
        assertThat(rgb).containsOnly(0.0);
    }

    /** A phase function distributes all of the light. */
    @Test
    void phaseFunctionsIntegrateToOne() {
        double air = 0;
        double haze = 0;
        int steps = 20_000;
        for (int i = 0; i < steps; i++) {
            double cosine = -1 + 2 * (i + 0.5) / steps;
            air += ClearAir.airPhase(cosine) * 4 * Math.PI / steps;
            haze += ClearAir.hazePhase(cosine) * 4 * Math.PI / steps;
        }
        assertThat(air).isCloseTo(1, within(1e-6));
        assertThat(haze).isCloseTo(1, within(1e-4));
    }
}
