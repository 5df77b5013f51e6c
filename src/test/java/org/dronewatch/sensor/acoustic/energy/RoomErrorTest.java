package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Readings by the default settings scatter as much as they state in small and large rooms whose surfaces absorb much or
 * little, and scatter much or little; where one surface absorbs far more than the others, in a corridor, and from one
 * room through a doorway to another. Where surfaces absorb much, few rays pass the source; a few strong ones would
 * decide. In the largest rooms that absorb much, four in a hundred are off by more than three stated errors.
 */
class RoomErrorTest {
    private static final int SEEDS = LongForm.count(40, 200);
    private static final long FIRST = 500;

    /** About one stated error of a reading: means of both ways are that close, dB. */
    private static final double EXCHANGED = 0.25;

    private static final SurfaceMaterial WALL = SurfaceMaterial.uniform("wall", 0.1, 0.1);

    @ParameterizedTest
    @CsvSource({
        "7, 5, 3, 0.6, 0.3",
        "14, 5, 3, 0.6, 0.3",
        "14, 5, 3, 0.6, 0.05",
        "14, 5, 3, 0.4, 0.8",
        "20, 12, 6, 0.6, 0.3",
        "20, 12, 6, 0.4, 0.3",
        "10, 8, 4, 0.3, 0.1",
        "10, 8, 4, 0.2, 0.3"
    })
    void readingsScatterAsTheySay(double x, double y, double z, double absorbed, double scattered) {
        World room = Sites.world(Sites.room(x, y, z), SurfaceMaterial.uniform("wall", absorbed, scattered));
        Position one = new Position(1.3, 1.1, 1);
        Position other = new Position(x - 1.8, 0.68 * y, 1.5);
        check(room, one, other);
        check(room, other, one);
    }

    /** The ceiling absorbs nearly everything, the other surfaces hardly anything. */
    @Test
    void readingsBelowAnAbsorbingCeilingScatterAsTheySay() {
        checkBothWays(underAbsorbingCeiling(), new Position(0.3, 0.1, 0), new Position(13.9, 4.95, 2.9));
    }

    @Test
    void readingsInACorridorScatterAsTheySay() {
        checkBothWays(Sites.world(Sites.room(40, 2, 2.5), WALL), new Position(2, 0.7, 1), new Position(37, 1.4, 2.3));
    }

    /** From one room to the other, and into the doorway between them. */
    @Test
    void readingsBetweenTwoRoomsScatterAsTheySay() {
        World rooms = Sites.world(World.merge(List.of(Sites.room(14, 5, 3), doorway())), WALL);
        checkBothWays(rooms, new Position(2, 4, 1.2), new Position(12, 4.5, 1.5));
        checkBothWays(rooms, new Position(2, 4, 1.2), new Position(7, 1, 1));
    }

    /** The drone lies on the floor. */
    @Test
    void readingsBetweenTwoRoomsWithAbsorbingCeilingsScatterAsTheySay() {
        checkBothWays(underAbsorbingCeiling(doorway()), new Position(2, 4, 0), new Position(12, 4.5, 1.5));
    }

    /** The wall between two rooms, with a doorway. */
    private static TriangleMesh doorway() {
        return World.merge(List.of(
                Sites.wall(0, 7, 0, 0.5, 0, 3), Sites.wall(0, 7, 1.5, 5, 0, 3), Sites.wall(0, 7, 0.5, 1.5, 2.1, 3)));
    }

    /** A room of 14 x 5 x 3 m. */
    private static World underAbsorbingCeiling(TriangleMesh... inside) {
        TriangleMesh walls = World.merge(Stream.concat(
                        Stream.of(
                                Sites.wall(2, 0, 0, 14, 0, 5),
                                Sites.wall(0, 0, 0, 5, 0, 3),
                                Sites.wall(0, 14, 0, 5, 0, 3),
                                Sites.wall(1, 0, 0, 3, 0, 14),
                                Sites.wall(1, 5, 0, 3, 0, 14)),
                        Stream.of(inside))
                .toList());
        SurfaceMaterial ceiling = SurfaceMaterial.uniform("ceiling", 0.9, 0.3);
        return Sites.world(List.of(walls, Sites.wall(2, 3, 0, 14, 0, 5)), List.of(WALL, ceiling));
    }

    /** As {@link #check}; and exchanging drone and microphone changes the mean level by less than a reading's error. */
    private static void checkBothWays(World space, Position one, Position other) {
        double difference = check(space, one, other) - check(space, other, one);
        assertThat(difference)
                .as("difference when drone and microphone are exchanged, dB")
                .isBetween(-EXCHANGED, EXCHANGED);
    }

    /** Checks the readings of many seeds, and returns their mean, dB. */
    private static double check(World room, Position drone, Position microphone) {
        EnergyTracer tracer = new EnergyTracer(EnergyModel.DEFAULT, microphone, 0.5, room);
        double[] levels = new double[SEEDS];
        double[] errors = new double[SEEDS];
        double mean = 0.0;
        for (int i = 0; i < SEEDS; i++) {
            EnergyReading reading =
                    tracer.trace(Sites.broadband(drone), new SplittableRandom(FIRST + i), RayRecorder.NONE);
            levels[i] = reading.totalLevel();
            errors[i] = reading.standardError();
            mean += levels[i] / SEEDS;
        }
        double squares = 0.0;
        double stated = 0.0;
        int beyond = 0;
        for (int i = 0; i < SEEDS; i++) {
            squares += (levels[i] - mean) * (levels[i] - mean) / (SEEDS - 1);
            stated += errors[i] * errors[i] / SEEDS;
            beyond += Math.abs(levels[i] - mean) > 3.0 * errors[i] ? 1 : 0;
        }
        double ratio = Math.sqrt(squares / stated);
        System.out.printf(
                Locale.ROOT,
                "RoomErrorTest: seeds from %d, scatter %.3f dB, stated %.3f dB, ratio %.2f, %d beyond three%n",
                FIRST,
                Math.sqrt(squares),
                Math.sqrt(stated),
                ratio,
                beyond);
        assertThat(ratio).as("scatter over stated error").isBetween(0.7, 1.3);
        assertThat(beyond).as("readings beyond three stated errors").isLessThanOrEqualTo(SEEDS / 25 + 1);
        return mean;
    }
}
