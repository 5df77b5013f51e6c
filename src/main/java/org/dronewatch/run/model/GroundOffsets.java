package org.dronewatch.run.model;

import java.util.Arrays;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.function.Consumer;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.world.SiteModel;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Warns of models of buildings that float above the ground or are buried in it, for instance because their heights
 * refer to the ellipsoid and those of the terrain to sea level. What stands on another model, such as a mast on a roof,
 * is not compared with the ground.
 */
public final class GroundOffsets {
    /** An offset from the ground that exceeds the height or depth of most foundations, m. */
    private static final double DOUBTFUL = 3.0;

    private final SceneSettings settings;
    private final TriangleMesh mesh;
    private final Visibility visibility;
    private final double top;
    private final NavigableMap<Integer, SiteModel> parts;

    /**
     * The site of a scene.
     *
     * @param parts terrain, buildings and models of the world, in this order, by the first triangle of each
     */
    public GroundOffsets(SceneSettings settings, World world, NavigableMap<Integer, SiteModel> parts) {
        this.settings = settings;
        this.mesh = world.mesh();
        this.visibility = new Visibility(world);
        this.top = world.bounds().maxZ() + 1.0;
        this.parts = parts;
    }

    /** Gives one line for each model whose parts have a median offset of more than 3 m from the ground. */
    public void giveTo(Consumer<String> target) {
        int models = settings.world().models().size();
        if (parts.values().stream().noneMatch(part -> part.role() == ModelRole.TERRAIN)) {
            return;
        }
        int number = models - parts.size();
        for (Map.Entry<Integer, SiteModel> part : parts.entrySet()) {
            if (number >= 0 && part.getValue().role() == ModelRole.BUILDING) {
                Integer next = parts.higherKey(part.getKey());
                examine(number, part, next == null ? mesh.triangleCount() : next, target);
            }
            number++;
        }
    }

    private void examine(int number, Map.Entry<Integer, SiteModel> part, int end, Consumer<String> target) {
        double[] offsets = Arrays.stream(PlanClusters.lowestVertices(mesh, part.getKey(), end))
                .mapToDouble(vertex -> offset(vertex, part.getKey(), end))
                .filter(Double::isFinite)
                .sorted()
                .toArray();
        double median = offsets.length == 0 ? 0.0 : offsets[offsets.length / 2];
        if (Math.abs(median) > DOUBTFUL) {
            target.accept(String.format(
                    Locale.ROOT,
                    "%s: %s %.1f m %s the ground%s: its heights may refer to a different vertical datum; if so, correct them with"
                            + " world.models.%d.position",
                    part.getValue().file(),
                    offsets.length == 1 ? "its lowest point lies" : "its lowest points lie",
                    Math.abs(median),
                    median > 0.0 ? "above" : "below",
                    offsets.length == 1 ? "" : " (median of " + offsets.length + " separate parts)",
                    number));
        }
    }

    /** The height of a vertex above the ground, or above what it stands on, m; NaN where there is no ground. */
    private double offset(int vertex, int first, int end) {
        double z = mesh.vertexCoordinate(vertex, 2);
        double ground = Double.NaN;
        double nearest = Double.NaN;
        boolean isFound = visibility.findFirstAlong(
                mesh.vertexCoordinate(vertex, 0),
                mesh.vertexCoordinate(vertex, 1),
                top,
                0,
                0,
                -1,
                Double.POSITIVE_INFINITY);
        for (; isFound; isFound = visibility.findNext()) {
            int triangle = visibility.triangle();
            double above = z - (top - visibility.distance());
            if (triangle < first || triangle >= end) {
                nearest = Math.abs(above) < Math.abs(nearest) || Double.isNaN(nearest) ? above : nearest;
                boolean isGround = parts.floorEntry(triangle).getValue().role() == ModelRole.TERRAIN;
                ground = isGround && Double.isNaN(ground) ? above : ground;
            }
        }
        return Double.isNaN(ground) || Math.abs(nearest) > DOUBTFUL ? ground : nearest;
    }
}
