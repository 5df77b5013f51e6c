package org.dronewatch.report.coverage;

import java.util.Comparator;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.report.coverage.table.CoverageTable;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.sensor.Cause;

/**
 * What a map of causes shows about a cell: a cell that is covered with the required probability counts as detected,
 * whatever the cause in a single look is; for other cells, the map shows the dominant cause. Ordered as in a legend.
 *
 * @param kind what it is
 * @param cause the cause of a miss; {@link Cause#DETECTED} for a cell that is or was covered, and {@link Cause#UNKNOWN}
 *     for other cells that have none
 */
record CellState(StateKind kind, Cause cause) implements Comparable<CellState> {
    /** A cell that is covered with all sensors, but not with those that remain. */
    static final CellState LOST = new CellState(StateKind.LOST, Cause.DETECTED);

    /** A cell that is covered. */
    static final CellState COVERED = new CellState(StateKind.COVERED, Cause.DETECTED);

    /** A cell in which a sensor detects the drone, but too rarely or too late. */
    static final CellState TOO_RARELY = new CellState(StateKind.TOO_RARELY, Cause.DETECTED);

    /** A cell inside something solid. */
    static final CellState INSIDE = new CellState(StateKind.INSIDE, Cause.UNKNOWN);

    private static final CellState NO_SENSOR = new CellState(StateKind.NO_SENSOR, Cause.UNKNOWN);
    private static final CellState UNKNOWN = new CellState(StateKind.UNKNOWN, Cause.UNKNOWN);
    /** A cell outside the area that counts. */
    static final CellState OUTSIDE = new CellState(StateKind.OUTSIDE, Cause.UNKNOWN);

    private static final Comparator<CellState> LEGEND =
            Comparator.comparing(CellState::kind).thenComparing(CellState::cause);

    /** What a cell may be. */
    enum StateKind {
        /** A sensor covers it. */
        COVERED,
        /** Only sensors that are switched off cover it. */
        LOST,
        /** It is known, but there is no sensor. */
        NO_SENSOR,
        /** No sensor detects the drone in a look. */
        MISSED,
        /** A sensor detects the drone, but not with the probability, or within the time, that is asked for. */
        TOO_RARELY,
        /** Nothing can be said about it. */
        UNKNOWN,
        /** It is inside something solid. */
        INSIDE,
        /** It is outside the area that counts. */
        OUTSIDE
    }

    /** What a cell of a coverage is. */
    static CellState of(FieldCoverage coverage, int height, int column, int row) {
        if (coverage.field().isOutside(height, column, row)) {
            return OUTSIDE;
        }
        if (coverage.field().isInside(height, column, row)) {
            return INSIDE;
        }
        if (coverage.isUnknown(height, column, row)) {
            return UNKNOWN;
        }
        if (coverage.field().sensors().isEmpty()) {
            return NO_SENSOR;
        }
        if (coverage.isCovered(height, column, row)) {
            return COVERED;
        }
        Cause cause = coverage.cause(height, column, row);
        return cause == Cause.DETECTED ? TOO_RARELY : new CellState(StateKind.MISSED, cause);
    }

    @Override
    public int compareTo(CellState other) {
        return LEGEND.compare(this, other);
    }

    /** Its colour and pattern. */
    MapSheet.Fill fill() {
        return switch (kind) {
            case COVERED, MISSED, UNKNOWN -> CauseFills.of(cause);
            case LOST -> CauseFills.LOST;
            case NO_SENSOR -> CauseFills.NO_SENSOR;
            case TOO_RARELY -> CauseFills.TOO_RARELY;
            case INSIDE -> CauseFills.INSIDE;
            case OUTSIDE -> CauseFills.OUTSIDE;
        };
    }

    /** The state in words.
     *
     * @param isWithin whether the drone has to be detected within a time
     */
    String inWords(boolean isWithin) {
        return switch (kind) {
            case COVERED, MISSED, UNKNOWN -> CoverageTable.name(cause);
            case LOST -> "no longer covered";
            case NO_SENSOR -> "no sensor";
            case TOO_RARELY -> isWithin ? "detected given more time" : "detected, but less reliably";
            case INSIDE -> "inside something solid";
            case OUTSIDE -> "outside the area";
        };
    }

    /** Whether it is one of the known cells, of which a legend gives fractions. */
    boolean isKnown() {
        return kind.compareTo(StateKind.UNKNOWN) < 0;
    }
}
