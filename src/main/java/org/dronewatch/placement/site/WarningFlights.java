package org.dronewatch.placement.site;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.InputException;

/**
 * The warnings that each sensor by itself gives of straight inbound flights from every bearing and at every height, as
 * {@code coverage} finds them: together, sensors give the longest of their warnings. For one thread, which may have
 * {@link org.dronewatch.parallel.Workers}.
 */
final class WarningFlights {
    /** The number of cells along a side unless the length of a cell is given. */
    private static final double CELLS = 50.0;

    private final PlacePlan plan;
    private final SceneSettings scene;
    private final Stage stage;
    private final LayerStore store;
    private final FieldGrid grid;

    /**
     * The flights of a plan.
     *
     * @param scene the scene as it is, or under a condition
     * @param stage stage of that scene
     * @param store store of earlier assessments
     * @throws InputException when the scene has no protected zone, or the cells are too many
     */
    WarningFlights(PlacePlan plan, SceneSettings scene, Stage stage, LayerStore store) {
        this.plan = plan;
        this.scene = scene;
        this.stage = stage;
        this.store = store;
        if (stage.protection().isEmpty()) {
            throw new InputException(
                    "objective warning-time: the scene protects no zone for which a warning could" + " be given");
        }
        this.grid = cells();
    }

    private FieldGrid cells() {
        AirSettings air = plan.settings().air();
        try {
            if (air.area().isPresent()) {
                AreaZone zone = AreaZone.inPlan(air.area().get(), plan.present().alert())
                        .orElseThrow(() ->
                                new InputException("air.area " + air.area().get() + ": no such zone"));
                double side = FieldGrid.over(zone, air.square(), air.levels()).side();
                return FieldGrid.over(zone, air.cell().orElse(side / CELLS), air.levels());
            }
            Position middle = InboundTarget.of(plan.present(), stage.protection());
            double side = air.square();
            return FieldGrid.square(
                    AirGrid.printable(middle.x()),
                    AirGrid.printable(middle.y()),
                    side,
                    air.cell().orElse(side / CELLS),
                    air.levels());
        } catch (IllegalArgumentException e) {
            throw new InputException("air: " + e.getMessage(), e);
        }
    }

    /** The cells whose side is the step of the flights. */
    FieldGrid grid() {
        return grid;
    }

    /** The number of flights. */
    int size() {
        return InboundWarnings.BEARINGS * grid.heights().size();
    }

    /** The approximate number of cells at which a sensor has to be assessed. */
    long looks() {
        return (long) size() * grid.columns() / 2;
    }

    /** The warnings of some sensors, except those that the condition switches off. */
    InboundWarnings of(Map<String, SensorSettings<?>> sensors, IntConsumer progress) {
        Map<String, SensorSettings<?>> here = new LinkedHashMap<>(sensors);
        here.keySet().removeAll(scene.disabled());
        // A condition may change the scene's own sensors; the names of all others are new.
        here.replaceAll((name, sensor) -> scene.sensors().getOrDefault(name, sensor));
        AirSettings air = plan.settings().air();
        return InboundWarnings.of(
                Layout.alone(scene, here), stage, plan.drone(), grid, air.terms(), air.covered(), store, progress);
    }
}
