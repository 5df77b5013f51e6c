package org.dronewatch.report.coverage;

import java.util.Map;
import org.dronewatch.analysis.Coverage;
import org.dronewatch.analysis.CoverageGrid;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.sensor.Cause;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The tables of the coverage at one height, in machine-readable form. */
public final class PlanJson {
    private PlanJson() {}

    /**
     * The tables, with all keys: the area in which each sensor detects the drone, and the numbers of cells by cause.
     *
     * @param scene name of the scene
     * @param drone name of the drone
     */
    public static ObjectNode of(Coverage coverage, String scene, String drone) {
        CoverageGrid grid = coverage.grid();
        ObjectNode root = JsonNodeFactory.instance.objectNode();
        root.put("scene", scene);
        root.put("drone", drone);
        root.put("height_m", Numbers.rounded(grid.height()));
        root.put("side_m", Numbers.rounded(grid.side()));
        root.put("cells_per_side", grid.cells());
        root.put("cells_with_ground", coverage.groundCells());
        Map<String, Map<Cause, Integer>> causes = coverage.causes();
        ArrayNode sensors = root.putArray("sensors");
        coverage.sensors().forEach((id, sensor) -> {
            ObjectNode one = sensors.addObject();
            one.put("sensor", id);
            one.put("kind", sensor.kind());
            one.put("area_m2", Numbers.rounded(coverage.area(id)));
            ObjectNode cells = one.putObject("cells");
            cells.put(CauseKey.of(Cause.DETECTED), coverage.reachedCells(id));
            causes.get(id).forEach((cause, count) -> cells.put(CauseKey.of(cause), count));
        });
        return root;
    }
}
