package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;

import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Of which points of a drone's box the visible part is counted. */
class VisibleFractionTest {
    private static final double FAR = 1e5;

    /** Whose box reaches from 1 to 3 m to the east, 2 to 6 m to the north, and 3 to 11 m up. */
    private static Drone oblong() {
        TriangleMesh mesh = TriangleMesh.of(new float[] {1, 2, 3, 3, 6, 11, 3, 2, 3}, new int[] {0, 1, 2});
        Position origin = new Position(0, 0, 0);
        return new Drone("oblong", DroneSettings.of(ModelSettings.of("oblong"), Hover.at(origin)), KDTree.of(mesh));
    }

    /** A sheet in the plane where an axis is 0, over the whole width of a second and up to a limit of a third. */
    private static World sheet(int normal, int along, int limited, double limit) {
        float[][] corners = {{-50, -50}, {50, -50}, {50, (float) limit}, {-50, (float) limit}};
        float[] vertices = new float[12];
        for (int i = 0; i < 4; i++) {
            vertices[3 * i + normal] = 0;
            vertices[3 * i + along] = corners[i][0];
            vertices[3 * i + limited] = corners[i][1];
        }
        return World.of(TriangleMesh.of(vertices, new int[] {0, 1, 2, 0, 2, 3}));
    }

    private static double fraction(World world, Position radar) {
        return new VisibleFraction(world, radar).of(oblong());
    }

    /**
     * From far away, what lies below a limit is hidden: of the nine points four lie at a quarter of the box, the one in
     * the middle at half of it, and four at three quarters, along each of the axes.
     */
    @ParameterizedTest
    @CsvSource({"0.24, 9", "0.26, 5", "0.49, 5", "0.51, 4", "0.74, 4", "0.76, 0"})
    void alongEachAxisThePointsLieAtAQuarterHalfAndThreeQuarters(double part, int visible) {
        Position fromSouth = new Position(2, -FAR, 7);
        Position fromWest = new Position(-FAR, 4, 7);
        assertThat(fraction(sheet(1, 2, 0, 1 + 2 * part), fromSouth)).as("east").isEqualTo(visible / 9.0);
        assertThat(fraction(sheet(0, 2, 1, 2 + 4 * part), fromWest)).as("north").isEqualTo(visible / 9.0);
        assertThat(fraction(sheet(1, 0, 2, 3 + 8 * part), fromSouth)).as("up").isEqualTo(visible / 9.0);
    }
}
