package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Sound knows no up: a site turned as a whole, with drone and microphone, is heard alike. */
class AttitudeTest {
    private static final long SEED = 20261123;
    private static final int ATTITUDES = 100;
    private static final Position SOURCE = new Position(2, 3, 1.5);
    private static final Position SENSOR = new Position(7, 5, 1.7);
    private static final TriangleMesh ROOM = Sites.room(10, 8, 4);

    /** Three rows of a rotation, uniform over all (Shoemake, Graphics Gems III, 1992). */
    private static double[][] attitude(SplittableRandom random) {
        double u = random.nextDouble();
        double a = 2 * Math.PI * random.nextDouble();
        double b = 2 * Math.PI * random.nextDouble();
        double x = Math.sqrt(1 - u) * Math.sin(a);
        double y = Math.sqrt(1 - u) * Math.cos(a);
        double z = Math.sqrt(u) * Math.sin(b);
        double w = Math.sqrt(u) * Math.cos(b);
        return new double[][] {
            {1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
            {2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
            {2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}
        };
    }

    private static Position turned(Position place, double[][] by) {
        double[] at = {place.x(), place.y(), place.z()};
        double[] to = new double[3];
        for (int row = 0; row < 3; row++) {
            for (int axis = 0; axis < 3; axis++) {
                to[row] += by[row][axis] * at[axis];
            }
        }
        return new Position(to[0], to[1], to[2]);
    }

    private static TriangleMesh turned(TriangleMesh mesh, double[][] by) {
        float[] vertices = new float[9 * mesh.triangleCount()];
        int[] corners = new int[3 * mesh.triangleCount()];
        for (int corner = 0; corner < corners.length; corner++) {
            Position to = turned(
                    new Position(
                            mesh.coordinate(corner / 3, corner % 3, 0),
                            mesh.coordinate(corner / 3, corner % 3, 1),
                            mesh.coordinate(corner / 3, corner % 3, 2)),
                    by);
            vertices[3 * corner] = (float) to.x();
            vertices[3 * corner + 1] = (float) to.y();
            vertices[3 * corner + 2] = (float) to.z();
            corners[corner] = corner;
        }
        return TriangleMesh.of(vertices, corners);
    }

    /** All images of the first four orders, which have to be found, each once. */
    @Test
    void aRoomOfMirrorsHasTheSameImagesInAnyAttitude() {
        SurfaceMaterial wall = SurfaceMaterial.uniform("wall", 0.1, 0);
        EnergyModel model = EnergyModel.DEFAULT.withImageSourceOrder(4).withRays(1);
        double level = mirroredLevel(model, Sites.world(ROOM, wall), SOURCE, SENSOR);
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < ATTITUDES; i++) {
            double[][] by = attitude(random);
            World room = Sites.world(turned(ROOM, by), wall);
            assertThat(mirroredLevel(model, room, turned(SOURCE, by), turned(SENSOR, by)))
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
            double[][] by = attitude(random);
            EnergyReading turned = Sites.read(
                    model,
                    Sites.world(turned(street, by), brick),
                    Sites.broadband(turned(source, by)),
                    turned(sensor, by),
                    2 + i);
            double stated = Math.hypot(level.standardError(), turned.standardError());
            assertThat(turned.aWeightedLevel())
                    .as("attitude %d of seed %d", i, SEED)
                    .isCloseTo(level.aWeightedLevel(), within(4 * stated));
        }
    }
}
