package org.dronewatch.placement.site;

import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.setting.InputException;

/** The cells in which the candidates of a plan are assessed. */
final class AirGrid {
    /** The number of cells along a side unless the length of a cell is given. */
    private static final double CELLS = 50.0;

    private static final double NANOMETRES = 1e9;

    private AirGrid() {}

    /**
     * A coordinate of a centre, rounded to whole nanometres, so that commands that repeat it without loss are not full
     * of digits left by rounding errors.
     *
     * @param coordinate the coordinate, m
     */
    static double printable(double coordinate) {
        return Math.rint(NANOMETRES * coordinate) / NANOMETRES;
    }

    /**
     * The cells over the area of a plan or around its candidates.
     *
     * @throws InputException when the area is not one of the scene's zones, or the cells are too many
     */
    static FieldGrid of(PlacePlan plan) {
        AirSettings air = plan.settings().air();
        try {
            if (air.area().isPresent()) {
                AreaZone zone = ZoneWeights.zone(
                        air.area().get(), "air.area", plan.present().alert());
                double side = FieldGrid.over(zone, air.square(), air.levels()).side();
                return FieldGrid.over(zone, air.cell().orElse(side / CELLS), air.levels());
            }
            double east = plan.candidates().stream()
                    .mapToDouble(one -> one.sensor().position().x())
                    .average()
                    .orElse(0.0);
            double north = plan.candidates().stream()
                    .mapToDouble(one -> one.sensor().position().y())
                    .average()
                    .orElse(0.0);
            return FieldGrid.square(
                    printable(east),
                    printable(north),
                    air.square(),
                    air.cell().orElse(air.square() / CELLS),
                    air.levels());
        } catch (IllegalArgumentException e) {
            throw new InputException("air: " + e.getMessage(), e);
        }
    }
}
