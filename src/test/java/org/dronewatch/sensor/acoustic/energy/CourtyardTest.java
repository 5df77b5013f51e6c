package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Criterion;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * One end in a courtyard, the other one far outside and hidden: half of what is heard is scattered, much of it also
 * mirrored many times by the walls, so that it leaves the courtyard in narrow beams.
 *
 * <p>The references are independent random walks of 600 and 300 million rays from the courtyard, in air that absorbs
 * nothing; those that had been scattered were counted in a ball of 1.5 m about the other end.
 */
class CourtyardTest {
    /** A dozen determines a standard deviation to 21 %, two dozen to 15 %. */
    private static final int READINGS = LongForm.count(12, 24);

    /** Levels relative to the sound power, dB, and their standard errors. */
    enum Courtyard {
        WIDE(6, 6, 8, 0.1, new Position(2, -3, 1.5), new Position(60, 30, 25), -51.60, 0.02),
        DEEP(5, 4, 12, 0.15, new Position(1.5, -1, 2), new Position(50, -20, 30), -51.26, 0.024);

        private final World world;
        private final Position inside;
        private final Position outside;
        private final double level;
        private final double error;

        Courtyard(
                double halfX,
                double halfY,
                double height,
                double absorption,
                Position inside,
                Position outside,
                double level,
                double error) {
            double x = halfX + 8;
            double y = halfY + 8;
            TriangleMesh mesh = World.merge(List.of(
                    Sites.square(3000, 0),
                    Sites.box(-x, -y, 0, -halfX, y, height),
                    Sites.box(halfX, -y, 0, x, y, height),
                    Sites.box(-x, -y, 0, x, -halfY, height),
                    Sites.box(-x, halfY, 0, x, y, height)));
            this.world = Sites.world(mesh, SurfaceMaterial.uniform("wall", absorption, 0.2));
            this.inside = inside;
            this.outside = outside;
            this.level = level;
            this.error = error;
        }
    }

    @Thorough
    @ParameterizedTest
    @EnumSource
    void whatIsScatteredAgreesWithRandomWalks(Courtyard yard) {
        check(yard, yard.outside, yard.inside);
        check(yard, yard.inside, yard.outside);
    }

    private static void check(Courtyard yard, Position drone, Position microphone) {
        EnergyModel model = EnergyModel.DEFAULT.withCriterion(Criterion.BEST_BAND);
        EnergyTracer tracer = new EnergyTracer(model, microphone, 0.5, yard.world);
        double scattered = 0;
        double squares = 0;
        double whole = 0;
        double stated = 0;
        for (int seed = 0; seed < READINGS; seed++) {
            EnergyReading reading =
                    tracer.trace(Sites.sound(drone, Sites.LOWEST), new SplittableRandom(seed), RayRecorder.NONE);
            assertThat(reading.isConverged()).isTrue();
            double energy = reading.reverberant().get(Sites.LOWEST);
            scattered += energy / READINGS;
            squares += energy * energy / READINGS;
            whole += reading.energy(Sites.LOWEST) / READINGS;
            stated += reading.standardError() / READINGS;
        }
        double deviation = Math.sqrt(squares - scattered * scattered);
        double error = Levels.ofRatio(1 + deviation / scattered / Math.sqrt(READINGS - 1));
        // What the mean of all readings is off by, as an error of the whole level, is well below what one of them
        // states.
        double off = scattered - Levels.toRatio(yard.level + Sites.LW);
        assertThat(Math.abs(Levels.ofRatio(1 + off / whole)))
                .as("%s, microphone at %s, stated error %.3f dB", yard, microphone, stated)
                .isLessThan(0.7 * stated);
        assertThat(Levels.ofRatio(scattered) - Sites.LW)
                .as("%s, microphone at %s", yard, microphone)
                .isCloseTo(yard.level, within(0.1 + 3 * Math.hypot(error, yard.error)));
        assertThat(Levels.ofRatio(1 + deviation / whole) / stated)
                .as("%s, microphone at %s: standard deviation over stated error", yard, microphone)
                .isBetween(0.7, 1.4);
    }
}
