package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.acoustic.energy.Sites.LOWEST;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BandFractions;
import org.dronewatch.sound.surface.AbsorptionAtAngle;
import org.dronewatch.sound.surface.OwnSurface;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Absorption that depends on the angle acts alike in exact reflections, in traced rays and in scattered sound. */
class AngularSurfaceTest {
    private static final EnergyModel ALL_RAYS =
            EnergyModel.DEFAULT.withAccuracy(0.0).withRoulette(1e-3);

    /** A locally reacting wall whose impedance is twice that of air: it absorbs 8/9 upright and all at 60 degrees. */
    private static double absorbed(double cosine) {
        return 8 * cosine / Math.pow(1 + 2 * cosine, 2);
    }

    private static SurfaceMaterial wall(double scattering) {
        List<AbsorptionAtAngle> table = new ArrayList<>();
        for (int i = 0; i <= 360; i++) {
            double angle = Math.PI / 2 * i / 360;
            double value = Math.min(1.0, absorbed(Math.max(0.0, Math.cos(angle))));
            table.add(new AbsorptionAtAngle(angle, BandFractions.flat(value)));
        }
        return OwnSurface.DEFAULT
                .withAbsorptionByAngle(table)
                .withScattering(BandFractions.flat(scattering))
                .material("wall");
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 5, 20, 60, 300})
    void aLocallyReactingWallReflectsByTheAngle(double apart) {
        World world = Sites.world(Sites.square(5000, 0), wall(0));
        Position sensor = new Position(0, 0, 3);
        EnergyReading reading =
                Sites.read(ALL_RAYS.withRays(1000), world, Sites.sound(new Position(apart, 0, 7), LOWEST), sensor, 1);

        double direct = Math.hypot(apart, 4);
        double mirrored = Math.hypot(apart, 10);
        double air = Atmosphere.STANDARD.attenuations()[LOWEST] * Math.log(10) / 10;
        double spread = Math.pow(direct / mirrored, 2) * Math.exp(-air * (mirrored - direct));
        assertThat(reading.mirrored().get(LOWEST) / reading.direct().get(LOWEST))
                .as("the table is linear between quarters of a degree")
                .isCloseTo((1 - absorbed(10 / mirrored)) * spread, within(2e-4));
    }

    /** Three walls that meet at a right corner: by exact paths, or all but the first order by rays. */
    @Test
    void tracedRaysReflectAsExactPathsDo() {
        TriangleMesh corner = World.merge(List.of(
                Sites.wall(0, 0, 0, 500, 0, 500), Sites.wall(1, 0, 0, 500, 0, 500), Sites.wall(2, 0, 0, 500, 0, 500)));
        World world = Sites.world(corner, wall(0));
        Position source = new Position(4, 7, 5);
        Position sensor = new Position(3, 2, 1.5);
        double expected = 0.0;
        for (int image = 1; image < 8; image++) {
            double x = (image & 1) == 0 ? 4 : -4;
            double y = (image & 2) == 0 ? 7 : -7;
            double z = (image & 4) == 0 ? 5 : -5;
            double length = new Position(x, y, z).distance(sensor);
            double kept = 1.0;
            kept *= (image & 1) == 0 ? 1.0 : 1 - absorbed(Math.abs(3 - x) / length);
            kept *= (image & 2) == 0 ? 1.0 : 1 - absorbed(Math.abs(2 - y) / length);
            kept *= (image & 4) == 0 ? 1.0 : 1 - absorbed(Math.abs(1.5 - z) / length);
            expected += kept / (length * length);
        }
        double direct = 1 / Math.pow(source.distance(sensor), 2);
        EnergyReading exact = Sites.read(ALL_RAYS.withRays(1000), world, Sites.sound(source, LOWEST), sensor, 1);
        assertThat(exact.mirrored().get(LOWEST) / exact.direct().get(LOWEST))
                .isCloseTo(expected / direct, within(1e-3 * expected / direct));

        EnergyReading traced = Sites.read(
                ALL_RAYS.withImageSourceOrder(1).withRays(400_000), world, Sites.sound(source, LOWEST), sensor, 2);
        assertThat(traced.mirrored().get(LOWEST)).isLessThan(exact.mirrored().get(LOWEST));
        assertThat(traced.totalLevel())
                .as("standard error %f dB, seed 2", traced.standardError())
                .isCloseTo(exact.totalLevel(), within(4 * traced.standardError() + 0.02));
    }

    /**
     * One plane that only scatters, by brute force over its area: what a point sends on is {@code r(in) r(out) / (pi
     * r(mean))}, the one product that works both ways and keeps the energy.
     */
    @Thorough
    @Test
    void whatIsScatteredFollowsTheAngleBothWays() {
        double half = 60;
        World world = Sites.world(Sites.square(half, 0), wall(1));
        Position source = new Position(6, 0, 4);
        Position sensor = new Position(-3, 1, 1.5);
        double mean = 1 - 8 / 2.0 * (1 + 1 / 3.0 - Math.log(3));
        double expected = 0.0;
        int steps = 1000;
        double step = 2 * half / steps;
        for (int i = 0; i < steps; i++) {
            for (int j = 0; j < steps; j++) {
                double x = -half + (i + 0.5) * step;
                double y = -half + (j + 0.5) * step;
                double in = Math.sqrt(Math.pow(source.x() - x, 2) + Math.pow(source.y() - y, 2) + 16);
                double out = Math.sqrt(Math.pow(sensor.x() - x, 2) + Math.pow(sensor.y() - y, 2) + 2.25);
                double cosIn = 4 / in;
                double cosOut = 1.5 / out;
                expected += (1 - absorbed(cosIn))
                        * (1 - absorbed(cosOut))
                        / (Math.PI * mean)
                        * cosIn
                        / (4 * Math.PI * in * in)
                        * cosOut
                        / (out * out)
                        * step
                        * step;
            }
        }
        double direct = 1 / (4 * Math.PI * Math.pow(source.distance(sensor), 2));
        for (Position[] ends : new Position[][] {{source, sensor}, {sensor, source}}) {
            EnergyReading reading =
                    Sites.read(ALL_RAYS.withRays(400_000), world, Sites.sound(ends[0], LOWEST), ends[1], 3);
            double scattered = reading.reverberant().get(LOWEST);
            assertThat(scattered / reading.direct().get(LOWEST))
                    .as("standard error %f dB, seed 3", reading.standardError())
                    .isCloseTo(expected / direct, within(0.01 * expected / direct));
        }
    }

    /** A room whose walls scatter: nothing is lost or gained, whatever the angle. */
    @Thorough
    @Test
    void theEnergyBalances() {
        World room = Sites.world(Sites.room(10, 8, 4), wall(0.6));
        EnergyReading there = Sites.read(
                ALL_RAYS.withRays(60_000),
                room,
                Sites.sound(new Position(2, 3, 1.5), LOWEST),
                new Position(7, 5, 0.3),
                4);
        EnergyReading back = Sites.read(
                ALL_RAYS.withRays(60_000),
                room,
                Sites.sound(new Position(7, 5, 0.3), LOWEST),
                new Position(2, 3, 1.5),
                5);

        assertThat(there.audit().imbalance()).isCloseTo(0.0, within(1e-9));
        assertThat(there.totalLevel())
                .as("seeds 4 and 5")
                .isCloseTo(back.totalLevel(), within(4 * Math.hypot(there.standardError(), back.standardError())));
    }
}
