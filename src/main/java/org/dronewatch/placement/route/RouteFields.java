package org.dronewatch.placement.route;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.cell.RouteHeights;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.site.Layout;
import org.dronewatch.route.FlightMode;
import org.dronewatch.route.LayoutRoutes;
import org.dronewatch.route.ModeField;
import org.dronewatch.route.RouteArea;
import org.dronewatch.route.SensorFields;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;

/**
 * The rates at which each sensor of a plan detects the drone on its way to the protected zone, in the scene as it is or
 * under one of its conditions.
 */
final class RouteFields {
    /** The number of cells along a side unless the length of a cell is given. */
    private static final double CELLS = 50.0;

    /** Maximum number of cells over all heights and under all conditions. */
    private static final int MOST = 250_000;

    private final PlacePlan plan;
    private final SceneSettings scene;
    private final Stage stage;
    private final LayerStore store;
    private final Drone drone;
    private final List<FlightMode> modes;
    private final FieldGrid grid;

    /**
     * The fields of a plan.
     *
     * @param scene the scene as it is, or under a condition
     * @param stage stage of that scene
     * @param store store of earlier assessments
     * @param grid the {@linkplain #grid cells} of the plan
     */
    RouteFields(PlacePlan plan, SceneSettings scene, Stage stage, LayerStore store, FieldGrid grid) {
        this.plan = plan;
        this.scene = scene;
        this.stage = stage;
        this.store = store;
        this.drone = DetectionField.droneOf(stage, plan.drone());
        this.modes = FlightMode.of(drone.settings(), plan.sensors());
        this.grid = grid;
    }

    /**
     * The cells of a plan, which are the same under all conditions.
     *
     * @param stage stage of the scene as it is
     * @throws InputException when the scene has no protected zone, or the cells are too many
     */
    static FieldGrid grid(PlacePlan plan, Stage stage) {
        if (stage.protection().isEmpty()) {
            throw new InputException("objective weakest-route: the scene protects no zone to which routes could lead");
        }
        AirSettings air = plan.settings().air();
        Position middle = InboundTarget.of(plan.present(), stage.protection());
        double side = air.side().orElseGet(() -> RouteArea.side(plan.present(), stage, plan.drone()));
        List<Double> heights = air.heights()
                .orElseGet(() -> RouteHeights.upTo(DetectionField.droneOf(stage, plan.drone())
                        .settings()
                        .flightLimits()
                        .ceiling()));
        FieldGrid cells;
        try {
            cells = new FieldGrid(middle.x(), middle.y(), side, air.cell().orElse(side / CELLS), heights);
        } catch (IllegalArgumentException e) {
            throw new InputException("air: " + e.getMessage(), e);
        }
        int scenes = 1 + plan.conditions().size();
        long count = (long) scenes * cells.cells() * cells.heights().size();
        if (cells.columns() < 2 || count > MOST) {
            throw new InputException("air.cell " + cells.cell() + " m: " + cells.columns() + " x " + cells.columns()
                    + " cells at " + Counted.of(cells.heights().size(), "height")
                    + (scenes > 1 ? " under " + scenes + " conditions" : "")
                    + "; there must be at least 2 x 2, and at most " + MOST + " in all");
        }
        return cells;
    }

    /** Names of the sensors that are switched off. */
    Set<String> disabled() {
        return scene.disabled();
    }

    /** The weakest routes past sensors that have been assessed. */
    LayoutRoutes routes(List<SensorFields> sensors) {
        return new LayoutRoutes(sensors, stage, plan.drone());
    }

    /** The approximate number of cells at which a sensor has to be assessed. */
    long looks() {
        return (long) modes.size() * grid.cells() * grid.heights().size();
    }

    /** The fields of a sensor, by itself; it counts as switched on. */
    SensorFields of(String name, SensorSettings<?> sensor, IntConsumer progress) {
        // A condition may change the scene's own sensors; the names of all others are new.
        SceneSettings alone = Layout.alone(scene, Map.of(name, scene.sensors().getOrDefault(name, sensor)));
        FieldTerms terms = FieldTerms.ONE_LOOK.withPointing(plan.pointing());
        List<ModeField> fields = new ArrayList<>();
        for (FlightMode mode : modes) {
            FieldRequest request = new FieldRequest(
                    alone,
                    stage,
                    plan.drone(),
                    grid,
                    mode.courses(alone.enabledSensors(), drone),
                    FieldCoverage.Choice.WORST,
                    terms,
                    FieldCoverage.DEFAULT_COVERED);
            fields.add(mode.with(FieldAssessment.of(request, store, progress), drone.settings()));
        }
        return new SensorFields(alone, fields);
    }
}
