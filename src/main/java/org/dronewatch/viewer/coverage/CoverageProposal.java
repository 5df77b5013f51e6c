package org.dronewatch.viewer.coverage;

import java.util.Arrays;
import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.world.SurfaceColumn;
import org.dronewatch.world.World;

/**
 * The area and the heights that are proposed for a coverage: those of the command or, if all sensors are under a roof
 * and the site is smaller, the site and heights below the ceiling.
 *
 * @param side length of the area's side, m
 * @param heights above the ground, in ascending order, m
 */
record CoverageProposal(double side, List<Double> heights) {
    /** The proposal of the command. */
    static final CoverageProposal OUTDOORS = new CoverageProposal(FieldGrid.DEFAULT_SIDE, FieldGrid.HEIGHTS);

    private static final List<Double> INDOORS = List.of(2.0, 5.0, 10.0, 20.0);

    /** The length of which the side is a multiple, m. */
    private static final double STEP = 10.0;

    /** The proposal for a scene and its world. */
    static CoverageProposal of(SceneSettings settings, World world) {
        double[] clear = settings.enabledSensors().values().stream()
                .mapToDouble(sensor -> clearance(sensor.position(), world))
                .toArray();
        if (clear.length == 0 || Arrays.stream(clear).anyMatch(Double::isInfinite)) {
            return OUTDOORS;
        }
        double lowest = Arrays.stream(clear).min().getAsDouble();
        double side = STEP * Math.ceil(2.0 * reach(InboundTarget.sensors(settings), world.bounds()) / STEP);
        List<Double> low = INDOORS.stream().filter(height -> height < lowest).toList();
        return side < FieldGrid.DEFAULT_SIDE && !low.isEmpty() ? new CoverageProposal(side, low) : OUTDOORS;
    }

    /** The height of the ceiling over a sensor, from the ground, m; infinite under the open sky. */
    private static double clearance(Position sensor, World world) {
        SurfaceColumn column = SurfaceColumn.at(world, sensor.x(), sensor.y());
        double ground = column.ground().map(SurfaceColumn.Surface::z).orElse(Double.NEGATIVE_INFINITY);
        return column.surfaces().stream()
                        .mapToDouble(SurfaceColumn.Surface::z)
                        .filter(z -> z > sensor.z())
                        .min()
                        .orElse(Double.POSITIVE_INFINITY)
                - ground;
    }

    /** Half the side of the square, about a given centre, that contains the site, m. */
    private static double reach(Position middle, AABB site) {
        double east = Math.max(site.maxX() - middle.x(), middle.x() - site.minX());
        double north = Math.max(site.maxY() - middle.y(), middle.y() - site.minY());
        return Math.max(east, north);
    }
}
