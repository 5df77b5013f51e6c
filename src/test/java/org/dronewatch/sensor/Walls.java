package org.dronewatch.sensor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.world.SiteModel;
import org.dronewatch.world.World;

/** Sites of thin walls across the way to the north, and cubes that fly behind them. */
public final class Walls {
    /** Where nothing stands in any way. */
    public static final TriangleMesh FAR = wall(-1e5, -1.0, 1.0);

    private Walls() {}

    /** A wall of 400 m to both sides, at a place to the north, from one height to another. */
    public static TriangleMesh wall(double north, double bottom, double top) {
        float y = (float) north;
        float low = (float) bottom;
        float high = (float) top;
        return new TriangleMesh(
                new float[] {-400, y, low, 400, y, low, 400, y, high, -400, y, high},
                new int[] {0, 1, 2, 0, 2, 3},
                new int[2],
                new int[] {0, 1},
                List.of("stuff"));
    }

    /** A flat block of 100 m depth: its front, and the roof that is seen from above. */
    public static TriangleMesh block(double north, double top) {
        float y = (float) north;
        float high = (float) top;
        return new TriangleMesh(
                new float[] {
                    -400, y, -999, 400, y, -999, 400, y, high, -400, y, high, 400, y + 100, high, -400, y + 100, high
                },
                new int[] {0, 1, 2, 0, 2, 3, 3, 2, 4, 3, 4, 5},
                new int[4],
                new int[] {0, 1, 2, 3},
                List.of("stuff"));
    }

    /** A level ceiling over everything. */
    public static TriangleMesh ceiling(double height) {
        float z = (float) height;
        return new TriangleMesh(
                new float[] {-999, -999, z, 999, -999, z, 999, 999, z, -999, 999, z},
                new int[] {0, 1, 2, 0, 2, 3},
                new int[2],
                new int[] {0, 1},
                List.of("stuff"));
    }

    /** A site in which nothing stands in any way. */
    public static World open() {
        return World.of(FAR);
    }

    /** A site of one wall, of a model of some role. */
    public static World behind(TriangleMesh wall, ModelRole role) {
        TreeMap<Integer, SiteModel> models = new TreeMap<>();
        models.put(0, new SiteModel("far.obj", ModelRole.OTHER));
        models.put(2, new SiteModel("wall.obj", role));
        return World.of(World.merge(List.of(FAR, wall))).withModels(models);
    }

    /** A site of one wall below a ceiling of the same model, a building. */
    public static World behindBelow(TriangleMesh wall, double height) {
        return behind(World.merge(List.of(wall, ceiling(height))), ModelRole.BUILDING);
    }

    /** A cube of 1 m that stands still. */
    public static Drone cube(Position place) {
        return cube(place, new Position(0, 0, 0));
    }

    /** A cube of 1 m that flies, nose to the north. */
    public static Drone cube(Position place, Position velocity) {
        return cube(DroneSettings.of(ModelSettings.of("cube.obj"), Hover.at(place)), place, velocity);
    }

    /** A cube of 1 m of some settings. */
    public static Drone cube(DroneSettings settings, Position place, Position velocity) {
        float[] corners = new float[24];
        for (int i = 0; i < 8; i++) {
            for (int axis = 0; axis < 3; axis++) {
                corners[3 * i + axis] = (i >> axis & 1) == 0 ? -0.5F : 0.5F;
            }
        }
        int[] quads = {0, 2, 3, 1, 4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
        int[] triangles = new int[36];
        for (int quad = 0; quad < 6; quad++) {
            int[] order = {0, 1, 2, 0, 2, 3};
            for (int k = 0; k < 6; k++) {
                triangles[6 * quad + k] = quads[4 * quad + order[k]];
            }
        }
        return new Drone("drone", settings, KDTree.of(TriangleMesh.of(corners, triangles)))
                .at(new FlightState(place, velocity, 0.0));
    }

    /** What a sensor that draws no rays makes of a drone; its probability is the same without a reason for a miss. */
    public static Assessment assess(SensorSettings<?> settings, World world, Drone drone) {
        Assessor assessor = new Assessor("sensor", settings, world);
        double alone = assessor.probability(drone, Optional.empty(), new SplittableRandom(1));
        Assessment whole = assessor.assess(drone, Optional.empty(), new SplittableRandom(1));
        assertThat(alone).isEqualTo(whole.probability());
        return whole;
    }

    /** A look of a fresh sensor. */
    public static Observation look(SensorSettings<?> settings, World world, Drone drone, long seed) {
        return settings.create()
                .observe(world, List.of(drone), Look.of(seed, "sensor", 0, 10.0))
                .get(0);
    }
}
