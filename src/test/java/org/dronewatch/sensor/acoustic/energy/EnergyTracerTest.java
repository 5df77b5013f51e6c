package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.acoustic.energy.Sites.LOWEST;
import static org.dronewatch.sensor.acoustic.energy.Sites.readInFull;

import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.imagesource.WallPlanes;
import org.dronewatch.sensor.acoustic.propagation.BandSurfaces;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * How the rays of the energy model are traced: where they end, what they count, and that chance and threads change
 * nothing.
 */
class EnergyTracerTest {
    private static final Position SOURCE = new Position(2, 3, 1.5);

    @Test
    void theAuditClosesWithEverythingInIt() {
        SurfaceMaterial window = SurfaceMaterial.uniform("wall", 0.5, 0.4).withTransmissionLoss(6, Wall.SHEET);
        EnergyReading reading = readInFull(
                Sites.world(Sites.room(10, 8, 4), window), SOURCE, new Position(7, 5, 1.7), 0.4, 20_000, 7, 9);

        EnergyAudit audit = reading.audit();
        assertThat(audit.imbalance()).isCloseTo(0.0, within(1e-9));
        assertThat(audit.absorbed()).isPositive();
        assertThat(audit.air()).isPositive();
        assertThat(audit.escaped()).isPositive();
        assertThat(audit.gained()).isPositive();
        assertThat(audit.lost()).isPositive();
    }

    /** Walls that absorb nothing: all energy that is lost is lost to the air, until the roulette ends the ray. */
    @ParameterizedTest
    @ValueSource(doubles = {0.0, 0.3})
    void whatRigidWallsReflectIsLostToTheAir(double scattering) {
        World rigid = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("rigid", 0, scattering));
        EnergyAudit audit = readInFull(rigid, SOURCE, new Position(7, 5, 1.7), 0.4, 1000, 7, 9)
                .audit();
        assertThat(audit.absorbed()).isZero();
        assertThat(audit.air()).isGreaterThan(0.9);
    }

    /** In the lowest band, the air of a small room takes hardly anything: the walls absorb it all. */
    @Test
    void whatIsNotLostToTheAirTheWallsAbsorb() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, 0.3));
        EnergyAudit audit = readInFull(room, SOURCE, new Position(7, 5, 1.7), 0.4, 1000, LOWEST, 9)
                .audit();
        assertThat(audit.air()).isBetween(1e-5, 1e-2);
        assertThat(audit.absorbed()).isGreaterThan(0.98);
    }

    /** A plane that only mirrors leaves the rays nothing: that no ray has found anything is no accuracy. */
    @Test
    void asLongAsNothingIsFoundTheRaysGoOn() {
        World plane = Sites.world(Sites.square(5000, 0), SurfaceMaterial.uniform("rigid", 0, 0));
        EnergyModel model = EnergyModel.DEFAULT.withRays(3000);
        SoundSource sound = Sites.sound(new Position(100, 0, 50), LOWEST);
        EnergyReading reading = Sites.read(model, plane, sound, new Position(0, 0, 1.5), 1);

        assertThat(reading.traced()).isGreaterThanOrEqualTo(3000);
        assertThat(reading.reverberant().get(LOWEST)).isZero();
    }

    @Test
    void atOrderZeroNothingIsScattered() {
        World plane = Sites.world(Sites.square(500, 0), SurfaceMaterial.uniform("rough", 0.1, 1));
        SoundSource sound = Sites.sound(new Position(20, 0, 5), LOWEST);
        Position sensor = new Position(0, 0, 1.5);
        EnergyModel model = EnergyModel.DEFAULT.withRays(3000);

        assertThat(Sites.read(model.withMaxOrder(0), plane, sound, sensor, 1)
                        .reverberant()
                        .get(LOWEST))
                .isZero();
        assertThat(Sites.read(model.withMaxOrder(1), plane, sound, sensor, 1)
                        .reverberant()
                        .get(LOWEST))
                .isPositive();
    }

    /** A fifth of the radius above a floor, 0.648 of a ball are free: the ball less a cap of height 0.8 radii. */
    @Test
    void aBallThatReachesThroughAFloorIsLess() {
        World floor = Sites.world(Sites.square(50, 0), SurfaceMaterial.uniform("floor", 0.2, 0));
        Air air = new Air(Atmosphere.STANDARD);
        BandSurfaces surfaces = new BandSurfaces(floor.surfaces());
        ReceiverSphere ball = new ReceiverSphere(
                0.5, floor, new WallPlanes(floor.mesh(), surfaces), surfaces, air, new EnergyTally(air));
        double whole = 4.0 / 3.0 * Math.PI * 0.125;

        ball.surround(new Position(0, 0, 0.1), 1.0);
        assertThat(ball.volume(0.5)).isCloseTo(0.648 * whole, within(0.01 * whole));
        ball.surround(new Position(0, 0, 0.6), 1.0);
        assertThat(ball.volume(0.5)).isCloseTo(whole, within(1e-9));
    }

    /** Late mirror reflections do not depend on how much of the ball about the drone the floor cuts off. */
    @Test
    void aDroneJustAboveTheFloorIsHeardAsLoudWithAnyRadius() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, 0));
        EnergyModel model = EnergyModel.DEFAULT.withRays(60_000).withAccuracy(0.0);
        Position sensor = new Position(7, 5, 1.7);
        SoundSource low = Sites.sound(new Position(3, 2.5, 0.12), LOWEST);
        EnergyReading wide =
                new EnergyTracer(model, sensor, 0.6, room).trace(low, new SplittableRandom(31), RayRecorder.NONE);
        EnergyReading narrow =
                new EnergyTracer(model, sensor, 0.11, room).trace(low, new SplittableRandom(32), RayRecorder.NONE);

        assertThat(wide.totalLevel())
                .as("standard errors %.2f and %.2f dB", wide.standardError(), narrow.standardError())
                .isCloseTo(
                        narrow.totalLevel(),
                        within(3 * Math.hypot(wide.standardError(), narrow.standardError()) + 0.05));
    }

    @Test
    void silenceIsHeardAsSilence() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, 0.3));
        EnergyReading reading = Sites.read(
                EnergyModel.DEFAULT.withRays(100), room, Sites.sound(SOURCE, -1), new Position(7, 5, 1.7), 1);
        assertThat(reading.totalLevel()).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    @Test
    void theSameSeedGivesTheSame() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, 0.3));
        EnergyReading first = readInFull(room, SOURCE, new Position(7, 5, 1.7), 0.4, 1000, LOWEST, 5);
        EnergyReading second = readInFull(room, SOURCE, new Position(7, 5, 1.7), 0.4, 1000, LOWEST, 5);

        assertThat(second.reverberant()).isEqualTo(first.reverberant());
        assertThat(second.audit()).isEqualTo(first.audit());
    }

    /** Also where it stops early, between waves of batches: three threads have traced more than one by then. */
    @Test
    void theSameForAnyNumberOfThreads() {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, 0.3));
        EnergyModel model = EnergyModel.DEFAULT.withRays(40_000).withAccuracy(0.12);
        SoundSource sound = Sites.sound(SOURCE, LOWEST);
        EnergyReading alone = Sites.read(model, room, sound, new Position(7, 5, 1.7), 5);
        for (int threads = 1; threads <= 3; threads++) {
            try (Workers workers = new Workers(threads)) {
                EnergyReading together = workers.call(() -> Sites.read(model, room, sound, new Position(7, 5, 1.7), 5));
                assertThat(together.reverberant()).as("%d threads", threads).isEqualTo(alone.reverberant());
                assertThat(together.audit()).isEqualTo(alone.audit());
                assertThat(together.traced()).isEqualTo(alone.traced());
                assertThat(together.decay().levels()).isEqualTo(alone.decay().levels());
            }
        }
        assertThat(alone.standardError()).isLessThan(0.12);
    }

    /** Rays are recorded one by one; otherwise those of small rooms are traced in packets. */
    @ParameterizedTest
    @CsvSource({"0.0, 0.0, 2100", "0.3, 0.0, 2100", "0.3, 0.15, 40000"})
    void raysInPacketsGiveTheSameAsRaysAlone(double scattering, double accuracy, int rays) {
        World room = Sites.world(Sites.room(10, 8, 4), SurfaceMaterial.uniform("wall", 0.2, scattering));
        EnergyModel model = EnergyModel.DEFAULT.withRays(rays).withAccuracy(accuracy);
        Position sensor = new Position(7, 5, 1.7);
        SoundSource sound = Sites.broadband(SOURCE);
        EnergyReading together = Sites.read(model, room, sound, sensor, 5);
        RayRecorder recorder = (fromX, fromY, fromZ, toX, toY, toZ, level, order, received) -> {};
        EnergyReading alone =
                new EnergyTracer(model, sensor, 0.4, room).trace(sound, new SplittableRandom(5), recorder);
        assertThat(together.reverberant()).isEqualTo(alone.reverberant());
        assertThat(together.audit()).isEqualTo(alone.audit());
        assertThat(together.traced()).isEqualTo(alone.traced());
        assertThat(together.standardError()).isEqualTo(alone.standardError());
        assertThat(together.decay().levels()).isEqualTo(alone.decay().levels());
    }
}
