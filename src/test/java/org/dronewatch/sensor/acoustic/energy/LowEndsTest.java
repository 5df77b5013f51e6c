package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.acoustic.energy.Sites.LOWEST;
import static org.dronewatch.sensor.acoustic.energy.Sites.LW;

import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Drone and microphone both on the ground or just above it, among walls: every path along the ground has a companion
 * that is reflected by the ground somewhere on its way, which hardly any ray finds.
 */
class LowEndsTest {
    private static final long SEED = 20261201;
    private static final double ABSORBED = 0.04;

    /** What the air absorbs at 63 Hz, as a fraction of energy over a metre: ISO 9613-1 at 20 degrees and 50 %. */
    private static final double BY_AIR = 2.8e-5;

    /**
     * In a court between two parallel walls and one across their ends, the images lie in two rows, twice because of the
     * ground. Those of more than twenty walls, 0.3 % of the energy, are left to rays.
     */
    @ParameterizedTest
    @CsvSource({
        "9, 0, 0",
        "9, 0, 0.001",
        "9, 0.001, 0.001",
        "9, 0.01, 0.01",
        "9, 0.03, 0.03",
        "9, 0.1, 0.1",
        "9, 0.3, 0.3",
        "9, 1, 1",
        "9, 0.3, 3",
        "30, 0, 0",
        "30, 0.001, 0.001",
        "30, 0.1, 0.1",
        "30, 1, 1"
    })
    void inACourtAllImagesAreHeardInAnyAttitude(double half, double ofDrone, double ofMicrophone) {
        Position drone = new Position(0.03 * half, 0.02 * half, ofDrone);
        Position microphone = new Position(-0.94 * half, 0.55 * half, ofMicrophone);
        double expected = inCourt(half, drone, microphone);
        TriangleMesh court = World.merge(List.of(
                Sites.square(20 * half, 0),
                Sites.wall(0, -half, -half, 2 * half, 0, 12),
                Sites.wall(0, half, -half, 2 * half, 0, 12),
                Sites.wall(1, -half, 0, 12, -half, half)));
        SurfaceMaterial smooth = SurfaceMaterial.uniform("smooth", ABSORBED, 0);
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < LongForm.count(3, 20); i++) {
            UnaryOperator<Position> by = i == 0 ? position -> position : Sites.attitude(random);
            World world = Sites.world(Sites.turned(court, by), smooth);
            EnergyReading reading = Sites.read(
                    EnergyModel.DEFAULT, world, Sites.sound(by.apply(drone), LOWEST), by.apply(microphone), SEED);
            assertThat(reading.totalLevel())
                    .as("attitude %d of seed %d", i, SEED)
                    .isCloseTo(expected, within(0.03));
        }
    }

    private static double inCourt(double half, Position drone, Position microphone) {
        double sum = 0.0;
        for (int n = -400; n <= 400; n++) {
            double x = 2 * half * n + (n % 2 == 0 ? drone.x() : -drone.x());
            for (int across = 0; across < 2; across++) {
                double y = across == 0 ? drone.y() : -2 * half - drone.y();
                for (int down = 0; down < 2; down++) {
                    Position image = new Position(x, y, down == 0 ? drone.z() : -drone.z());
                    sum += heard(Math.abs(n) + across + down, image.distance(microphone));
                }
            }
        }
        return LW + 10 * Math.log10(sum);
    }

    private static double heard(int order, double distance) {
        return Math.pow(1 - ABSORBED, order) * Math.exp(-BY_AIR * distance) / (4 * Math.PI * distance * distance);
    }

    /** Each image of a room once (Allen and Berkley, JASA 65, 1979), up to an order that rays have to find. */
    @Test
    void onTheFloorOfARoomAllImagesAreFoundOnceInAnyAttitude() {
        int order = 4;
        EnergyModel model = EnergyModel.DEFAULT.withImageSourceOrder(order).withRays(1);
        SurfaceMaterial smooth = SurfaceMaterial.uniform("smooth", ABSORBED, 0);
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < LongForm.count(12, 100); i++) {
            UnaryOperator<Position> by = i % 2 == 0 ? position -> position : Sites.attitude(random);
            World room = Sites.world(Sites.turned(Sites.room(10, 8, 4), by), smooth);
            Position drone = onFloor(random);
            Position microphone = onFloor(random);
            EnergyReading reading =
                    Sites.read(model, room, Sites.sound(by.apply(drone), LOWEST), by.apply(microphone), SEED);
            assertThat(10 * Math.log10(reading.mirrored().get(LOWEST)))
                    .as("attitude %d of seed %d, %s and %s", i, SEED, drone, microphone)
                    .isCloseTo(inRoom(order, drone, microphone), within(0.01));
        }
    }

    private static Position onFloor(SplittableRandom random) {
        return new Position(
                random.nextDouble(0.5, 9.5), random.nextDouble(0.5, 7.5), Math.pow(10, random.nextDouble(-3, -0.5)));
    }

    private static double inRoom(int most, Position drone, Position microphone) {
        double sum = 0.0;
        for (int i = -most; i <= most; i++) {
            for (int j = -most; j <= most; j++) {
                for (int k = -most; k <= most; k++) {
                    int order = Math.abs(i) + Math.abs(j) + Math.abs(k);
                    Position image =
                            new Position(image(i, 10, drone.x()), image(j, 8, drone.y()), image(k, 4, drone.z()));
                    sum += order == 0 || order > most ? 0.0 : heard(order, image.distance(microphone));
                }
            }
        }
        return LW + 10 * Math.log10(sum);
    }

    private static double image(int n, double side, double at) {
        return n % 2 == 0 ? n * side + at : (n + 1) * side - at;
    }
}
