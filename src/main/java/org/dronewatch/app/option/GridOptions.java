package org.dronewatch.app.option;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.CoverageGrid;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.In;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Spelling;
import picocli.CommandLine.Option;

/** The options of {@code coverage} for the cells in which the drone is placed. */
public final class GridOptions {
    private static final String HEIGHTS = "--heights";
    private static final String CELL = "--cell";
    private static final String CENTRE = "--centre";
    private static final String AREA = "--area";

    /** A side is a whole number of cells if it deviates by less than this fraction. */
    private static final double ROUNDING = 1e-9;

    @Option(
            names = HEIGHTS,
            paramLabel = "H,H,...",
            description = "Heights above the ground; 10, 30, 60, 120 and 150 m by default.")
    private String heights;

    @Option(
            names = CELL,
            paramLabel = "L",
            description = "Length of a cell's side; a hundredth of the area's side by default.")
    private String cell;

    @Option(
            names = CENTRE,
            paramLabel = "POINT",
            description =
                    "Centre of the area, east and north in the scene's frame, such as 100m,-50m; the centroid of the"
                            + " sensors by default.")
    private String centre;

    @Option(
            names = AREA,
            paramLabel = "NAME",
            description = "A protected zone of the scene, in place of --side: only cells whose centre is in it count.")
    private String area;

    /** The options with what was given for each; null where nothing was. */
    Map<String, Object> values() {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put(HEIGHTS, heights);
        values.put(CELL, cell);
        values.put(CENTRE, centre);
        values.put(AREA, area);
        return values;
    }

    /**
     * The cells: of a protected area, or around the sensors.
     *
     * @param side length of the side around the sensors, m; empty if none was given
     */
    FieldGrid grid(SceneSettings settings, OptionalDouble side) {
        if (area != null && (side.isPresent() || centre != null)) {
            throw new InputException(GivenOption.words(AREA, area) + ": cannot be combined with "
                    + (side.isPresent() ? "--side" : CENTRE));
        }
        Position middle = centre == null ? InboundTarget.sensors(settings) : centre();
        List<Double> above = heights == null ? FieldGrid.HEIGHTS : heights(heights);
        try {
            return area == null
                    ? square(middle, side.orElse(FieldGrid.DEFAULT_SIDE), above)
                    : over(AreaZone.inPlan(area, settings.alert()).orElseThrow(() -> noArea(settings)), above);
        } catch (IllegalArgumentException e) {
            throw new InputException((cell == null ? "--side" : CELL) + ": " + e.getMessage(), e);
        }
    }

    /** A note if the side of the area differs from what was asked for; otherwise empty. */
    public static Optional<String> wholeCells(FieldGrid grid) {
        double side = grid.columns() * grid.cell();
        if (grid.area().isPresent() || Math.abs(side - grid.side()) <= ROUNDING * side) {
            return Optional.empty();
        }
        String length = Numbers.text(side) + " m";
        return Optional.of("the side of the area is " + length + " instead of " + Numbers.text(grid.side())
                + " m, so that it is a whole number of cells of " + Numbers.text(grid.cell()) + " m");
    }

    private Position centre() {
        String[] parts = centre.split(",", -1);
        if (parts.length != 2) {
            throw new InputException(GivenOption.words(CENTRE, centre) + ": must be EAST,NORTH, such as 100m,-50m");
        }
        return new Position(
                (double) FieldOptions.value("centre", parts[0].strip(), FieldGrid.class, "east"),
                (double) FieldOptions.value("centre", parts[1].strip(), FieldGrid.class, "north"),
                0.0);
    }

    private FieldGrid square(Position middle, double side, List<Double> above) {
        return FieldGrid.square(middle.x(), middle.y(), side, edge(side), above);
    }

    private FieldGrid over(AreaZone zone, List<Double> above) {
        double side = FieldGrid.over(zone, In.FARTHEST, above).side();
        FieldGrid grid = FieldGrid.over(zone, edge(side), above);
        if (grid.count((column, row) -> !grid.isOutside(column, row)) == 0) {
            throw new InputException(CELL + " " + grid.cell() + " m: must be smaller, since no cell has its centre in '"
                    + zone.name() + "'");
        }
        return grid;
    }

    private double edge(double side) {
        return cell == null
                ? side / FieldGrid.DEFAULT_CELLS
                : (double) FieldOptions.value("cell", cell, FieldGrid.class, "cell");
    }

    private InputException noArea(SceneSettings settings) {
        List<String> known = new ArrayList<>(settings.alert().zones().keySet());
        settings.alert().protect().ifPresent(ball -> known.add(Protection.ZONE));
        return new InputException(GivenOption.words(AREA, area) + ": no such zone; the scene protects "
                + (known.isEmpty() ? "nothing" : String.join(", ", known)) + Spelling.didYouMean(area, known));
    }

    /** The name of the protected area; empty if none was given. */
    Optional<String> area() {
        return Optional.ofNullable(area);
    }

    /**
     * The heights of a list, m.
     *
     * @param given value of the option
     */
    static List<Double> heights(String given) {
        List<Double> parsed = new ArrayList<>();
        for (String one : given.split(",", -1)) {
            parsed.add((Double) FieldOptions.value("heights", one.strip(), CoverageGrid.class, "height"));
        }
        try {
            return FieldGrid.checkedHeights(parsed);
        } catch (IllegalArgumentException e) {
            throw new InputException(HEIGHTS + ": " + e.getMessage(), e);
        }
    }
}
