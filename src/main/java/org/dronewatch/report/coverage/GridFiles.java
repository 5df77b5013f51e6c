package org.dronewatch.report.coverage;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.geo.Origin;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.coverage.table.CoverageTable;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.report.file.OutputDirectory;
import org.dronewatch.report.map.CoverageMap;
import org.dronewatch.report.map.GeoTiff;
import org.dronewatch.report.map.GeoTiff.CellClass;
import org.dronewatch.sensor.Cause;

/** The files for geographic information systems: GeoTIFF for the cells, GeoJSON and KML for the gaps. */
final class GridFiles {
    private static final int INSIDE = Cause.values().length;
    private static final int TOO_RARELY = INSIDE + 1;

    private final FieldSurvey survey;
    private final FieldCoverage coverage;
    private final boolean isWithin;
    private final FieldGrid grid;
    private final GeoTiff rasters;
    private final CoverageMap gaps;

    /**
     * The files of a coverage.
     *
     * @param origin geographic position of the scene's origin
     */
    GridFiles(FieldSurvey survey, CoverageInputs inputs, Origin origin) {
        this.survey = survey;
        this.coverage = survey.summary().coverage();
        this.isWithin = inputs.within().isPresent();
        this.grid = coverage.field().grid();
        this.rasters = new GeoTiff(origin, grid.east(), grid.north(), grid.cell(), grid.columns());
        this.gaps = new CoverageMap(
                coverage,
                inputs.scene(),
                origin,
                cause -> new CoverageMap.CauseStyle(CoverageTable.name(cause), CauseFills.colour(cause)));
    }

    void write(OutputDirectory directory) throws IOException {
        for (int height = 0; height < grid.heights().size(); height++) {
            String metres = Numbers.text(grid.heights().get(height));
            rasters.writeClasses(directory.file("cause-" + metres + ".tif"), causes(height), classes(isWithin));
            rasters.writeCounts(directory.file("count-" + metres + ".tif"), counts(height));
        }
        if (survey.detectable().isPresent()) {
            rasters.writeNumbers(
                    directory.file("min-height.tif"),
                    heights(survey.detectable().get()::height));
        }
        if (survey.visible().isPresent()) {
            rasters.writeNumbers(
                    directory.file("visible-height.tif"),
                    heights(survey.visible().get()::height));
        }
        gaps.writeGeoJson(directory.file("coverage.geojson"));
        gaps.writeKml(directory.file("coverage.kml"));
    }

    /**
     * The causes by their numbers, and what else a cell may be.
     *
     * @param isWithin whether the drone has to be detected within a time
     */
    static List<CellClass> classes(boolean isWithin) {
        List<CellClass> classes = new ArrayList<>();
        for (Cause cause : Cause.values()) {
            classes.add(new CellClass(CoverageTable.name(cause), CauseFills.colour(cause)));
        }
        classes.add(new CellClass(CellState.INSIDE.inWords(isWithin), CauseFills.insideColour()));
        classes.add(new CellClass(CellState.TOO_RARELY.inWords(isWithin), CauseFills.tooRarelyColour()));
        return classes;
    }

    private byte[] causes(int height) {
        byte[] cells = new byte[grid.cells()];
        grid.forEachCell((column, row) -> cells[grid.cell(column, row)] = (byte) number(height, column, row));
        return cells;
    }

    /** The number of the class of a cell, as on the maps. */
    private int number(int height, int column, int row) {
        CellState state = CellState.of(coverage, height, column, row);
        return switch (state.kind()) {
            case OUTSIDE -> GeoTiff.NO_CLASS;
            case INSIDE -> INSIDE;
            case TOO_RARELY -> TOO_RARELY;
            default -> state.cause().ordinal();
        };
    }

    /** The number of sensors that cover each cell; none for those that do not count. */
    private int[] counts(int height) {
        int[] cells = new int[grid.cells()];
        grid.forEachCell((column, row) -> cells[grid.cell(column, row)] =
                coverage.isKnown(height, column, row) ? coverage.count(height, column, row) : -1);
        return cells;
    }

    /** A height for each column. */
    private interface Heights {
        double at(int column, int row);
    }

    private float[] heights(Heights heights) {
        float[] cells = new float[grid.cells()];
        grid.forEachCell((column, row) -> cells[grid.cell(column, row)] = (float) heights.at(column, row));
        return cells;
    }
}
