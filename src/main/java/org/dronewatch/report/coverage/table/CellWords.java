package org.dronewatch.report.coverage.table;

import static org.dronewatch.report.html.ReadableNumbers.measured;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalInt;
import org.dronewatch.analysis.cell.Margin;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.survey.CellExaminer.CellEvidence;
import org.dronewatch.analysis.survey.GapEvidence;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;

/**
 * Describes one cell of a coverage: whether each sensor detects the drone there, or why not, and which sensor
 * determines the cause: the one that has the highest probability of detection or, in a tie, comes nearest to a
 * detection.
 */
public final class CellWords {
    private static final double LEAST_SHOWN = 0.005;
    private static final String NO_SIGNAL = "no signal";
    private static final String DECIBELS = "dB";

    private final FieldCoverage coverage;
    private final SceneSettings settings;
    private final int height;
    private final int column;
    private final int row;

    /**
     * The words for a cell.
     *
     * @param settings settings of the scene
     * @param height index of the height in the grid, from 0 for the lowest
     * @param column column of the cell, from 0 in the west
     * @param row row of the cell, from 0 in the north
     */
    public CellWords(FieldCoverage coverage, SceneSettings settings, int height, int column, int row) {
        this.coverage = coverage;
        this.settings = settings;
        this.height = height;
        this.column = column;
        this.row = row;
    }

    /** The state of the cell according to the detection field: {@code 30 m above the ground: hidden by terrain}. */
    public String summary() {
        return above() + state();
    }

    private String above() {
        return Numbers.text(coverage.field().grid().heights().get(height)) + " m above the ground: ";
    }

    private String state() {
        if (coverage.field().isOutside(height, column, row)) {
            return "outside the area";
        }
        if (coverage.field().isInside(height, column, row)) {
            return "inside something solid";
        }
        if (!coverage.field().isOpen(height, column, row)) {
            return "unknown, since there is no ground";
        }
        if (coverage.isUnknown(height, column, row)) {
            return "unknown, since a line of sight leaves the known ground";
        }
        return coverage.field().sensors().isEmpty()
                ? "no sensor"
                : name(coverage.cause(height, column, row), coverage.isCovered(height, column, row));
    }

    /** What is detected in a look, but not with the probability that is asked for, is not covered. */
    private static String name(Cause cause, boolean isCovered) {
        return cause == Cause.DETECTED && !isCovered ? CoverageTable.TOO_RARELY : CoverageTable.name(cause);
    }

    /** The probability that a sensor, given by its index, detects the drone; a dash where no drone can be. */
    public String probability(int sensor) {
        if (!coverage.field().isOpen(height, column, row)) {
            return "-";
        }
        return probability(
                coverage.field().probability(sensor, height, column, row, coverage.courseAt(height, column, row)));
    }

    private static String probability(double value) {
        if (value == 0.0 || value == 1.0) {
            return value == 0.0 ? "0" : "1";
        }
        if (value < LEAST_SHOWN || value > 1.0 - LEAST_SHOWN) {
            return value < LEAST_SHOWN ? "<0.01" : ">0.99";
        }
        return String.format(Locale.ROOT, "%.2f", value);
    }

    /**
     * States that a sensor, given by its index, detects the drone, or why it does not, according to the detection
     * field. Empty where no drone can be.
     */
    public String cause(int sensor) {
        if (!coverage.field().isOpen(height, column, row)) {
            return "";
        }
        Cause cause = coverage.cause(sensor, height, column, row);
        return name(cause, coverage.covers(sensor, height, column, row));
    }

    /**
     * The margin by which the signal of a sensor, given by its index, exceeds its threshold, as precisely as the field
     * stores it: {@code +3.2 dB}, {@code <= -12 dB} or {@code no signal}; empty if the field stores only its sign.
     */
    public String margin(int sensor) {
        Margin margin = kept(sensor);
        return switch (margin.kind()) {
            case NO_SIGNAL -> NO_SIGNAL;
            case VALUE -> signed(margin.db());
            case AT_LEAST -> margin.db() > 0.0 ? ">= " + signed(margin.db()) : "";
            case AT_MOST -> margin.db() < 0.0 ? "<= " + signed(margin.db()) : "";
            case NOTHING -> "";
        };
    }

    private Margin kept(int sensor) {
        return coverage.field().margin(sensor, height, column, row, coverage.courseAt(height, column, row));
    }

    private static String signed(double db) {
        return (db < 0.0 ? "-" : "+") + measured(Math.abs(db), DECIBELS);
    }

    /**
     * The state of the cell according to the detection field, and the sensor that determines the cause, if the margins
     * that the field stores suffice to identify that sensor.
     */
    public String deciding() {
        OptionalInt sensor = coverage.field().isOpen(height, column, row)
                ? coverage.deciding(height, column, row)
                : OptionalInt.empty();
        return sensor.isEmpty()
                ? summary() + "."
                : summary() + ". '" + coverage.field().sensors().get(sensor.getAsInt())
                        + "' determines the cause: probability " + probability(sensor.getAsInt())
                        + inWords(kept(sensor.getAsInt())) + ".";
    }

    private static String inWords(Margin margin) {
        String distance = measured(Math.abs(margin.db()), DECIBELS);
        return switch (margin.kind()) {
            case NO_SIGNAL -> ", " + NO_SIGNAL;
            case VALUE -> ", " + distance + (margin.db() < 0.0 ? " below" : " above") + " its threshold";
            case AT_LEAST -> margin.db() > 0.0 ? ", at least " + distance + " above its threshold" : "";
            case AT_MOST -> margin.db() < 0.0 ? ", at least " + distance + " below its threshold" : "";
            case NOTHING -> "";
        };
    }

    /**
     * The difference between signal and threshold: {@code +3.2 dB}, or {@code no signal}; empty if it is positive and
     * infinite.
     */
    public static String margin(GapEvidence.Examined examined) {
        Assessment assessment = examined.assessment();
        double margin = assessment.margin();
        // Without a signal, such as with 0 pixels of a drone out of view, there is no finite margin.
        if (!Double.isFinite(margin) || assessment.marginDb() == Double.NEGATIVE_INFINITY) {
            return margin > 0.0 ? "" : NO_SIGNAL;
        }
        return (margin >= 0.0 ? "+" : "-") + measured(Math.abs(margin), assessment.unit());
    }

    /**
     * Why a sensor, given by its index, does not detect the drone, with the object that hides the drone or the limit
     * that applies.
     */
    public String reason(int sensor, GapEvidence.Examined examined) {
        String name = coverage.field().sensors().get(sensor);
        Assessment assessment = examined.assessment();
        if (assessment.cause() == Cause.TOO_WEAK) {
            return settings.sensors().get(name).description().weakness();
        }
        if (assessment.cause() == Cause.DETECTED) {
            return name(Cause.DETECTED, coverage.covers(sensor, height, column, row));
        }
        GapEvidence one = new GapEvidence(name, Map.of(assessment.cause(), 1), List.of(examined));
        return new MissWords(one, settings.sensors().get(name)).inWords();
    }

    /**
     * The state of the cell and the sensor that determines the cause, with its probability and its margin: {@code 30 m
     * above the ground: hidden by a building ('Town hall'). 'radar' determines the cause: probability 0, no signal.}
     */
    public String deciding(CellEvidence evidence) {
        int sensor = evidence.deciding();
        GapEvidence.Examined examined = evidence.sensors().get(sensor);
        String place = coverage.isUnknown(height, column, row) ? summary() : above() + reason(sensor, examined);
        return place + ". '" + coverage.field().sensors().get(sensor) + "' determines the cause: probability "
                + probability(sensor) + inWords(margin(examined), examined) + ".";
    }

    /** Empty for a margin that is not finite and positive. */
    private static String inWords(String margin, GapEvidence.Examined examined) {
        if (margin.startsWith("+") || margin.startsWith("-")) {
            return ", " + margin.substring(1) + (margin.startsWith("+") ? " above" : " below") + " its threshold of "
                    + measured(
                            examined.assessment().threshold(),
                            examined.assessment().unit());
        }
        return margin.isEmpty() ? "" : ", " + margin;
    }
}
