package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.dronewatch.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A closed house whose walls and roof transmit little: what its surfaces reflect and scatter before it comes through
 * the walls makes the sound outside 4 dB louder, and readings state how accurately they know this.
 *
 * <p>The reference is an independent random walk of 80 million rays among the same rectangles, in air that absorbs
 * nothing: walls reflect 0.5, of that scatter 0.3 by Lambert's law and transmit 0.1; the ground reflects 0.7, of that
 * scatters 0.3; rays were counted in a ball of 1 m about the end outside. With so little transmitted, all sound is in
 * proportion to the fraction transmitted.
 */
class TransmittingHouseTest {
    private static final Position INSIDE = new Position(3, 2, 1.5);
    private static final Position OUTSIDE = new Position(-20, 3, 1.5);
    private static final int SEEDS = LongForm.count(40, 200);
    private static final long FIRST = 900;

    /** All sound over direct sound, dB; standard error 0.012 dB. */
    private static final double OVER_DIRECT = 4.071;

    /** Rays through walls are counted in a wide sphere, in which the sound is up to this much louder, dB. */
    private static final double WIDE_SPHERE = 0.2;

    @ParameterizedTest
    @CsvSource({"10, true", "20, true", "20, false", "30, true", "30, false", "40, false"})
    void readingsThroughWallsScatterAsTheySay(double loss, boolean isDroneInside) {
        World world = house(loss);
        Position drone = isDroneInside ? INSIDE : OUTSIDE;
        Position microphone = isDroneInside ? OUTSIDE : INSIDE;
        EnergyTracer tracer = new EnergyTracer(EnergyModel.DEFAULT, microphone, 0.5, world);
        double[] levels = new double[SEEDS];
        double[] errors = new double[SEEDS];
        double energies = 0;
        double direct = 0;
        double mean = 0;
        for (int i = 0; i < SEEDS; i++) {
            EnergyReading reading =
                    tracer.trace(Sites.broadband(drone), new SplittableRandom(FIRST + i), RayRecorder.NONE);
            levels[i] = reading.aWeightedLevel();
            errors[i] = reading.standardError();
            mean += levels[i] / SEEDS;
            direct = reading.direct().get(Sites.LOWEST);
            energies += (direct
                            + reading.mirrored().get(Sites.LOWEST)
                            + reading.reverberant().get(Sites.LOWEST))
                    / SEEDS;
        }
        double squares = 0;
        double stated = 0;
        int beyond = 0;
        for (int i = 0; i < SEEDS; i++) {
            squares += (levels[i] - mean) * (levels[i] - mean) / (SEEDS - 1);
            stated += errors[i] * errors[i] / SEEDS;
            beyond += Math.abs(levels[i] - mean) > 3 * errors[i] ? 1 : 0;
        }
        String what = "seeds from %d, scatter %.3f dB".formatted(FIRST, Math.sqrt(squares));
        assertThat(Math.sqrt(squares / stated))
                .as("scatter over stated error, %s", what)
                .isLessThan(1.3);
        assertThat(beyond).as("beyond three stated errors, %s", what).isLessThanOrEqualTo(1 + SEEDS / 50);
        double error = Math.sqrt(squares / SEEDS);
        assertThat(Levels.ofRatio(energies / direct))
                .as("over direct sound, dB, %s", what)
                .isCloseTo(OVER_DIRECT, within(WIDE_SPHERE + 3 * error));
    }

    private static World house(double loss) {
        SurfaceMaterial wall = SurfaceMaterial.uniform("wall", 0.5, 0.3).withTransmissionLoss(loss, Wall.SHEET);
        TriangleMesh walls = World.merge(List.of(
                Sites.wall(2, 3, 0, 6, 0, 5),
                Sites.wall(0, 0, 0, 5, 0, 3),
                Sites.wall(0, 6, 0, 5, 0, 3),
                Sites.wall(1, 0, 0, 3, 0, 6),
                Sites.wall(1, 5, 0, 3, 0, 6)));
        return Sites.world(
                List.of(Sites.square(100, 0), walls), List.of(SurfaceMaterial.uniform("ground", 0.3, 0.3), wall));
    }
}
