package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sensor.acoustic.propagation.PathBending;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.Wind;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The profile of the wind begins on the ground, not on the roof of a house. */
class WindOverHousesTest {
    private static final EnergyModel MODEL = EnergyModel.DEFAULT.withRays(1);
    private static final TriangleMesh SITE =
            World.merge(List.of(Sites.square(3000, 0), Sites.box(190, -15, 0, 210, 15, 25)));

    private static World windy(double speed, double fromDegrees) {
        Atmosphere air = Atmosphere.STANDARD.withWind(new Wind(speed, Math.toRadians(fromDegrees), 0.03));
        return new World(KDTree.of(SITE), BackgroundNoise.of(20), List.of(SurfaceMaterials.get("asphalt")), air);
    }

    private static double level(World world, double x) {
        return RefractionTest.read(MODEL, world, new Position(x, 0, 27), new Position(0, 0, 1.5))
                .aWeightedLevel();
    }

    /** 2 m above the roof, over either of its edges: nothing changes but where the drone is. */
    @ParameterizedTest
    @CsvSource({"10, 270", "10, 90", "5, 270", "5, 90"})
    void overTheEdgeOfARoofTheLevelHasNoStep(double speed, double from) {
        World world = windy(speed, from);
        for (double edge : new double[] {190, 210}) {
            double before = level(world, edge - 0.01);

            assertThat(level(world, edge + 0.01)).as("edge at %.0f m", edge).isCloseTo(before, within(0.1));
        }
    }

    /** A drone and a microphone on a roof are in the wind of a mast that is as high. */
    @Test
    void onARoofTheWindIsThatOfAMast() {
        World world = windy(10, 270);
        PathBending bending = new PathBending(world);
        Position roof = new Position(200, 0, 26.5);
        Position mast = new Position(150, 0, 26.5);
        double expected = 10 * Math.log1p(26.5 / 0.03) / Math.log1p(10 / 0.03);

        assertThat(bending.windAt(mast)).isCloseTo(expected, within(1e-9));
        assertThat(bending.windAt(roof)).isCloseTo(expected, within(1e-9));
    }
}
