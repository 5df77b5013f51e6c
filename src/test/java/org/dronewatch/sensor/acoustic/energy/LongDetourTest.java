package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.acoustic.energy.Sites.LOWEST;
import static org.dronewatch.sensor.acoustic.energy.Sites.LW;

import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.Barrier;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Round large obstacles sound spreads over the whole way. */
class LongDetourTest {
    private static final SurfaceMaterial DEAF = SurfaceMaterial.uniform("deaf", 1, 0);

    /** Under and over a large plate: Maekawa's limit of 25 dB and spreading over the path, less what an edge takes. */
    @ParameterizedTest
    @ValueSource(doubles = {50, 500})
    void underAPlateSoundSpreadsOverTheWayRoundIt(double half) {
        Position source = new Position(1, 0, -2);
        Position sensor = new Position(20, 0, 2);
        Position edge = new Position(half, 0, 0);
        double way = source.distance(edge) + edge.distance(sensor);
        double air = Atmosphere.STANDARD.attenuations()[LOWEST] * way;
        double spread = LW - 10 * Math.log10(4 * Math.PI * way * way) - air;

        double level = level(half, source, sensor);
        assertThat(level).isCloseTo(spread - Barrier.LIMIT + 10 * Math.log10(3), within(0.05));
        assertThat(level).isLessThan(spread);
        assertThat(level(half, sensor, source)).as("exchanged").isCloseTo(level, within(1e-6));
    }

    /** Where the detour is short, as round barriers, the curve alone counts; from there on nothing jumps. */
    @Thorough
    @Test
    void nothingJumpsWhereTheDetourBecomesLong() {
        double before = Double.NaN;
        for (double half = 1; half < 40; half *= 1.002) {
            double level = level(half, new Position(0, 0, -2), new Position(0.5, 0, 2));
            assertThat(level).as("half width %f m", half).isFinite();
            if (half > 1) {
                assertThat(before - level).as("half width %f m", half).isBetween(-1e-6, 0.1);
            }
            before = level;
        }
        assertThat(EdgeLoss.overDetour(10, 17)).isEqualTo(1);
        assertThat(EdgeLoss.overDetour(10, 173.20508)).isCloseTo(0.01, within(1e-8));
    }

    private static double level(double half, Position source, Position sensor) {
        World plate = Sites.world(Sites.square(half, 0), DEAF);
        return Sites.read(EnergyModel.DEFAULT.withRays(1), plate, Sites.sound(source, LOWEST), sensor, 1)
                .totalLevel();
    }
}
