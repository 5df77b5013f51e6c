package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.acoustic.energy.Sites.LOWEST;
import static org.dronewatch.sensor.acoustic.energy.Sites.LW;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.Directivity;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Scattered sound in the open, against the integral over the plane that scatters it. */
class DiffuseConnectionTest {
    private static final SurfaceMaterial CHALK = SurfaceMaterial.uniform("chalk", 0.3, 1);
    private static final EnergyModel ALL = EnergyModel.DEFAULT.withAccuracy(0);

    /**
     * What a plane at z = 0 that reflects 0.7 by Lambert's law sends from source to sensor, over the source's power:
     * 0.7 times the integral of cos cos / (4 pi r1^2 pi r2^2), by the midpoint rule. The integrand is steep below
     * either end: each half-plane nearer to one of them is integrated in steps that grow from its foot.
     */
    private static double scattered(Position source, Position sensor, Directivity directivity, int band) {
        return 0.7
                * (aboutFoot(sensor, source, at -> integrand(at, source, sensor, directivity, band))
                        + aboutFoot(source, sensor, at -> integrand(at, source, sensor, directivity, band)));
    }

    private static double aboutFoot(Position foot, Position other, ToDoubleFunction<Position> integrand) {
        int steps = 600;
        int turns = 600;
        double sum = 0.0;
        for (int i = 0; i < steps; i++) {
            double u = (i + 0.5) / steps * Math.PI / 2;
            double rho = foot.z() * Math.tan(u);
            double width = foot.z() / (Math.cos(u) * Math.cos(u)) * Math.PI / 2 / steps;
            for (int k = 0; k < turns; k++) {
                double phi = 2 * Math.PI * (k + 0.5) / turns;
                Position at = new Position(foot.x() + rho * Math.cos(phi), foot.y() + rho * Math.sin(phi), 0);
                double there = Math.hypot(at.x() - other.x(), at.y() - other.y());
                // Smoothly shared: a sharp border would cost the rule its accuracy.
                double share = there * there * there / (there * there * there + rho * rho * rho);
                sum += share * integrand.applyAsDouble(at) * rho * width * 2 * Math.PI / turns;
            }
        }
        return sum;
    }

    private static double integrand(Position at, Position source, Position sensor, Directivity directivity, int band) {
        double m = Atmosphere.STANDARD.attenuations()[band] * Math.log(10) / 10;
        double r1 = at.distance(source);
        double r2 = at.distance(sensor);
        double gain = Levels.toRatio(directivity.index(band, Math.asin(-source.z() / r1)));
        return gain
                * source.z()
                / (4 * Math.PI * r1 * r1 * r1)
                * sensor.z()
                / (Math.PI * r2 * r2 * r2)
                * Math.exp(-m * (r1 + r2));
    }

    /** Near the ground and far away, and high up: from the sensor it takes few rays, wherever the source is. */
    @Thorough
    @ParameterizedTest
    @CsvSource({"0, 500, 40, 1.5", "0, 30, 3, 1.5", "0, 200, 100, 20"})
    void aPlaneThatScattersSendsItsIntegral(double x, double y, double z, double height) {
        World plane = Sites.world(Sites.square(20_000, 0), CHALK);
        Position source = new Position(x, y, z);
        Position sensor = new Position(0, 0, height);
        for (Directivity directivity : Directivity.values()) {
            int band = OctaveBands.ONE_KILOHERTZ;
            EnergyReading reading =
                    Sites.read(ALL.withRays(100_000), plane, Sites.sound(source, band, directivity), sensor, 5);
            double expected = Levels.toRatio(LW) * scattered(source, sensor, directivity, band);

            // The standard error is that of the whole level: seen by the scattered part alone it is larger.
            double whole = Levels.toRatio(reading.totalLevel());
            double error = whole * (Levels.toRatio(reading.standardError()) - 1.0);
            assertThat(reading.reverberant().get(band))
                    .as("%s, seed 5, relative error %f", directivity, error / expected)
                    .isCloseTo(expected, within(4 * error + 2e-3 * expected));
            assertThat(error / expected).isLessThan(0.01);
        }
    }

    /** What the default settings trace in the open is enough: few rays, and the stated error holds. */
    @Test
    void aMicrophoneFarOutIsAccurateWithFewRays() {
        World plane = Sites.world(Sites.square(20_000, 0), SurfaceMaterial.uniform("grass", 0.5, 0.45));
        Position sensor = new Position(0, 0, 1.5);
        SoundSource source = Sites.sound(new Position(0, 500, 50), LOWEST);
        EnergyReading careful = Sites.read(ALL.withRays(200_000), plane, source, sensor, 1);
        for (int seed = 10; seed < 20; seed++) {
            EnergyReading quick = Sites.read(EnergyModel.DEFAULT, plane, source, sensor, seed);
            assertThat(quick.standardError()).isLessThan(0.2);
            assertThat(quick.traced()).isLessThan(6000);
            assertThat(quick.totalLevel())
                    .as("seed %d", seed)
                    .isCloseTo(careful.totalLevel(), within(4 * quick.standardError() + 0.01));
        }
    }

    /** A sheet between source and plane weakens what the plane sends on, by its loss. */
    @Test
    void aConnectionIsWeakenedByEachWallItCrosses() {
        SurfaceMaterial sheet = SurfaceMaterial.uniform("sheet", 1, 0).withTransmissionLoss(10, Wall.SHEET);
        TriangleMesh ground = named(Sites.square(20_000, 0), "ground");
        TriangleMesh roof = named(Sites.square(19_000, 30), "sheet");
        World covered = new World(
                KDTree.of(World.merge(List.of(ground, roof))),
                BackgroundNoise.of(20),
                List.of(CHALK, sheet),
                Atmosphere.STANDARD);
        Position source = new Position(0, 40, 50);
        Position sensor = new Position(0, 0, 1.5);
        EnergyReading reading = Sites.read(ALL.withRays(50_000), covered, Sites.sound(source, LOWEST), sensor, 3);

        double expected = Levels.toRatio(LW) * scattered(source, sensor, Directivity.OMNIDIRECTIONAL, LOWEST) * 0.1;
        assertThat(reading.reverberant().get(LOWEST) / expected).isCloseTo(1.0, within(0.02));
    }

    private static TriangleMesh named(TriangleMesh mesh, String material) {
        float[] vertices = new float[3 * mesh.vertexCount()];
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = mesh.vertexCoordinate(i / 3, i % 3);
        }
        int[] corners = {0, 1, 2, 0, 2, 3};
        return new TriangleMesh(vertices, corners, new int[2], new int[] {0, 1}, List.of(material));
    }
}
