package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Sound knows no up: a site turned as a whole, with drone and microphone, is heard alike. */
class AttitudeTest {
    private static final long SEED = 20261123;

    /** Among the first attitudes of this seed is one in which rounding puts points of a sheet on its other side. */
    private static final long LEAKING = 5;

    private static final int ATTITUDES = LongForm.count(16, 100);
    private static final Position SOURCE = new Position(2, 3, 1.5);
    private static final Position SENSOR = new Position(7, 5, 1.7);
    private static final TriangleMesh ROOM = Sites.room(10, 8, 4);

    /** All images of the first four orders, which have to be found, each once. */
    @Test
    void aRoomOfMirrorsHasTheSameImagesInAnyAttitude() {
        SurfaceMaterial wall = SurfaceMaterial.uniform("wall", 0.1, 0);
        EnergyModel model = EnergyModel.DEFAULT.withImageSourceOrder(4).withRays(1);
        double level = mirroredLevel(model, Sites.world(ROOM, wall), SOURCE, SENSOR);
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < ATTITUDES; i++) {
            UnaryOperator<Position> by = Sites.attitude(random);
            World room = Sites.world(Sites.turned(ROOM, by), wall);
            assertThat(mirroredLevel(model, room, by.apply(SOURCE), by.apply(SENSOR)))
                    .as("attitude %d of seed %d", i, SEED)
                    .isCloseTo(level, within(0.05));
        }
    }

    private static double mirroredLevel(EnergyModel model, World world, Position source, Position sensor) {
        EnergyReading reading = Sites.read(model, world, Sites.broadband(source), sensor, 1);
        double sum = 0;
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            sum += reading.mirrored().get(band);
        }
        return 10 * Math.log10(sum);
    }

    /** With all that is scattered, too: no attitude differs by more than the readings' errors allow. */
    @Test
    void aStreetSoundsTheSameInAnyAttitude() {
        TriangleMesh street = World.merge(
                List.of(Sites.square(500, 0), Sites.box(-10, -15, 0, 0, 15, 10), Sites.box(20, -15, 0, 30, 15, 10)));
        SurfaceMaterial brick = SurfaceMaterial.uniform("brick", 0.1, 0.2);
        checkTurned(EnergyModel.DEFAULT, SEED, street, brick, new Position(-60, 5, 15), new Position(10, -3, 1.5));
    }

    /** A drone before two rooms with an open door from one to the other and one outside; walls let some sound pass. */
    @Thorough
    @Test
    void roomsWithDoorsAndThinWallsSoundTheSameInAnyAttitude() {
        SurfaceMaterial wall = SurfaceMaterial.uniform("wall", 0.2, 0.3).withTransmissionLoss(20, Wall.SHEET);
        checkTurned(
                EnergyModel.DEFAULT,
                SEED,
                OpenDoorTest.house(true, 1),
                wall,
                new Position(4, -15, 3),
                new Position(7.3, 2.1, 1.2));
    }

    /** No sound passes from one side of an opaque sheet to the other by a reflection in the sheet's own plane. */
    @Test
    void aThinOpaqueWallHidesTheSameInAnyAttitude() {
        TriangleMesh wall = World.merge(List.of(Sites.square(300, 0), Sites.wall(0, 20, -15, 15, 0, 6)));
        SurfaceMaterial rough = SurfaceMaterial.uniform("rough", 0.1, 0.3);
        EnergyModel exact = EnergyModel.DEFAULT.withAccuracy(0.05);
        checkTurned(exact, LEAKING, wall, rough, new Position(40, 3, 1.5), new Position(5, 0, 1.5));
    }

    private static void checkTurned(
            EnergyModel model,
            long seed,
            TriangleMesh site,
            SurfaceMaterial surface,
            Position source,
            Position sensor) {
        EnergyReading level = Sites.read(model, Sites.world(site, surface), Sites.broadband(source), sensor, 1);
        assertThat(level.standardError()).isBetween(1e-3, 0.5);
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < LongForm.count(4, 20); i++) {
            UnaryOperator<Position> by = Sites.attitude(random);
            EnergyReading turned = Sites.read(
                    model,
                    Sites.world(Sites.turned(site, by), surface),
                    Sites.broadband(by.apply(source)),
                    by.apply(sensor),
                    2 + i);
            double stated = Math.hypot(level.standardError(), turned.standardError());
            double difference = turned.aWeightedLevel() - level.aWeightedLevel();
            assertThat(difference).as("attitude %d of seed %d", i, seed).isCloseTo(0, within(4 * stated));
            assertThat(turned.isConverged()).isTrue();
        }
    }
}
