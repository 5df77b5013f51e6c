package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.SplittableRandom;
import java.util.concurrent.ThreadLocalRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Ground;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.GroundImpedance;
import org.dronewatch.sound.surface.GroundInterference;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.TurbulentCoherence;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Coherent ground upwind, from the lit side into the shadow, against the wave equation in turbulent air. */
class ShadowBorderTest {
    private static final double SPEED = Atmosphere.STANDARD.speedOfSound();

    /** Of rays upwind, 1/m: that of wind of 8 m/s between 10 m and 1.5 m. */
    private static final double CURVATURE = 9e-4;

    private static final double SOURCE = 10;
    private static final double RECEIVER = 1.5;

    /** Where rays from the source graze the ground on their way to the receiver, m. */
    private static final double BORDER = Math.sqrt(2 / CURVATURE) * (Math.sqrt(SOURCE) + Math.sqrt(RECEIVER));

    private static final SurfaceMaterial GRASS = SurfaceMaterial.uniform("grass_50mm", 0.5, 0);
    private static final EnergyModel MODEL = EnergyModel.DEFAULT.withRays(1).withGround(Ground.COHERENT);

    /** Delany and Bazley's admittance of grass, 200 kPa s/m2. */
    static ParabolicEquation overGrass(double frequency, double curvature, TurbulentCoherence turbulence) {
        double x = frequency / 200;
        double re = 1 + 9.08 * Math.pow(x, -0.75);
        double im = 11.9 * Math.pow(x, -0.73);
        double size = re * re + im * im;
        return new ParabolicEquation(
                2 * Math.PI * frequency / SPEED,
                curvature,
                re / size,
                -im / size,
                turbulence.strength(),
                turbulence.scale());
    }

    private static double[] levels(double curvature, double distance, double source, double receiver) {
        World world = RefractionTest.flat(GRASS, RefractionTest.withGradient(-curvature * SPEED));
        return RefractionTest.gains(MODEL, world, new Position(distance, 0, source), new Position(0, 0, receiver));
    }

    /**
     * Up to the border and just beyond it rays, images and coherence agree with the wave equation within 3 dB, of which
     * 1 dB is the scatter of ten realizations. Deeper, turbulence scatters more sound into the shadow than the curve of
     * edges leaves there.
     */
    @ParameterizedTest
    @CsvSource({"500, 3", "1000, 4"})
    void agreesWithTheParabolicEquation(double frequency, int band) {
        double[] wave = overGrass(frequency, CURVATURE, TurbulentCoherence.MODERATE)
                .gains(SOURCE, RECEIVER, 1.4 * BORDER, 10, new SplittableRandom(1));
        for (double distance = 0.55 * BORDER; distance < 1.37 * BORDER; distance += 0.05 * BORDER) {
            double expected = Levels.ofRatio(wave[ParabolicEquation.index(distance)]);
            assertThat(levels(CURVATURE, distance, SOURCE, RECEIVER)[band])
                    .as("%.0f Hz, %.2f of the way to the border", frequency, distance / BORDER)
                    .isCloseTo(expected, within(distance < 1.12 * BORDER ? 3.0 : 6.0));
        }
    }

    /** Without bending and turbulence it is the closed form over flat ground, so it may judge others. */
    @Test
    void theParabolicEquationIsThatOfFlatGroundInStillAir() {
        TurbulentCoherence still = new TurbulentCoherence(0, 1.1);
        double frequency = 500;
        double[] wave = new ParabolicEquation(2 * Math.PI * frequency / SPEED, 0, 0, 0, 0, 1.1)
                .gains(SOURCE, RECEIVER, 200, 1, new SplittableRandom(1));
        for (double distance = 60; distance < 200; distance += 10) {
            double direct = Math.hypot(distance, SOURCE - RECEIVER);
            double reflected = Math.hypot(distance, SOURCE + RECEIVER);
            GroundInterference rigid =
                    new GroundInterference(GroundImpedance.RIGID, SPEED, direct, reflected, SOURCE, RECEIVER, 0, still);
            double expected = rigid.atFrequency(frequency, 1, Math.pow(direct / reflected, 2));
            // Of 4 at most: 0.1 at the dip of the interference near 90 m, 4 far away.
            assertThat(wave[ParabolicEquation.index(distance)])
                    .as("%.0f m", distance)
                    .isCloseTo(expected, within(0.1));
        }
    }

    /** Once rays are as close as turbulence lets them come, every band falls with distance. */
    @ParameterizedTest
    @CsvSource({"5, 1.5", "10, 1.5", "30, 4"})
    void nothingRisesTowardsTheBorder(double source, double receiver) {
        double border = Math.sqrt(2 / CURVATURE) * (Math.sqrt(source) + Math.sqrt(receiver));
        World world = RefractionTest.flat(GRASS, RefractionTest.withGradient(-CURVATURE * SPEED));
        EnergyReading before = null;
        for (double share = 0.94; share < 1.05; share += 0.01) {
            Position drone = new Position(share * border, 0, source);
            EnergyReading here = RefractionTest.read(MODEL, world, drone, new Position(0, 0, receiver));
            for (int band = 0; before != null && band < OctaveBands.COUNT; band++) {
                assertThat(here.level(band)).as("%.2f, band %d", share, band).isLessThan(before.level(band));
            }
            before = here;
        }
    }

    /** From metre to metre through the border no band falls by more than the curve of edges alone. */
    @Test
    void noBandFallsSteeplyThroughTheBorder() {
        double[] before = levels(CURVATURE, BORDER - 40, SOURCE, RECEIVER);
        for (double distance = BORDER - 39; distance < BORDER + 40; distance++) {
            double[] here = levels(CURVATURE, distance, SOURCE, RECEIVER);
            for (int band = 0; band < OctaveBands.COUNT; band++) {
                assertThat(here[band])
                        .as("band %d, %.0f m beyond the border", band, distance - BORDER)
                        .isBetween(before[band] - 1.6, before[band] + 0.2);
            }
            before = here;
        }
    }

    /** Whatever the heights and the wind, both sides of the border meet. */
    @Test
    void bothSidesMeetAtTheBorder() {
        long seed = ThreadLocalRandom.current().nextLong();
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 14; i++) {
            double curvature = Math.exp(random.nextDouble(Math.log(2e-4), Math.log(1.6e-3)));
            double source = random.nextDouble(2, 60);
            // At equal heights the reflection off straight ground is seen up to the border, too.
            double receiver = i < 2 ? source : random.nextDouble(0.5, 8);
            double formula = Math.sqrt(2 / curvature) * (Math.sqrt(source) + Math.sqrt(receiver));
            double lit = 0.8 * formula;
            double dark = 1.1 * formula;
            while (dark - lit > 0.02) {
                double middle = 0.5 * (lit + dark);
                boolean isLit = isLit(curvature, middle, source, receiver);
                lit = isLit ? middle : lit;
                dark = isLit ? dark : middle;
            }
            double[] before = levels(curvature, lit, source, receiver);
            double[] behind = levels(curvature, dark, source, receiver);
            for (int band = 0; band < OctaveBands.COUNT; band++) {
                assertThat(behind[band])
                        .as("seed %d, pair %d, band %d, border at %.1f m", seed, i, band, lit)
                        .isCloseTo(before[band], within(0.5));
            }
        }
    }

    private static boolean isLit(double curvature, double distance, double source, double receiver) {
        World world = RefractionTest.flat(GRASS, RefractionTest.withGradient(-curvature * SPEED));
        return RefractionTest.read(MODEL, world, new Position(distance, 0, source), new Position(0, 0, receiver))
                        .direct()
                        .get(3)
                > 0;
    }
}
