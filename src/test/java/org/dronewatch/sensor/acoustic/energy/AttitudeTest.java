package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Sound knows no up: a site turned as a whole, with drone and microphone, is heard alike. */
class AttitudeTest {
    private static final long SEED = 20261123;
    private static final int ATTITUDES = 100;
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
        Position source = new Position(-60, 5, 15);
        Position sensor = new Position(10, -3, 1.5);
        EnergyModel model = EnergyModel.DEFAULT;
        EnergyReading level = Sites.read(model, Sites.world(street, brick), Sites.broadband(source), sensor, 1);
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 20; i++) {
            UnaryOperator<Position> by = Sites.attitude(random);
            EnergyReading turned = Sites.read(
                    model,
                    Sites.world(Sites.turned(street, by), brick),
                    Sites.broadband(by.apply(source)),
                    by.apply(sensor),
                    2 + i);
            double stated = Math.hypot(level.standardError(), turned.standardError());
            assertThat(turned.aWeightedLevel())
                    .as("attitude %d of seed %d", i, SEED)
                    .isCloseTo(level.aWeightedLevel(), within(4 * stated));
        }
    }
}
