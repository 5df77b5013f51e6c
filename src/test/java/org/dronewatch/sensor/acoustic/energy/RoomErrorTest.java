package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Readings by the default settings scatter as much as they state in small and large rooms whose surfaces absorb much or
 * little, and scatter much or little. Where surfaces absorb much, few rays pass the source; a few strong ones would
 * decide. In the largest rooms that absorb much, four in a hundred are off by more than three stated errors.
 */
class RoomErrorTest {
    private static final int SEEDS = LongForm.count(40, 200);
    private static final long FIRST = 500;

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

    private static void check(World room, Position drone, Position microphone) {
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
    }
}
