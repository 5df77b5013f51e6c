package org.dronewatch.report.coverage.table;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.analysis.field.DetectableHeights;
import org.dronewatch.analysis.field.VisibleHeights;
import org.dronewatch.analysis.layer.InterpolationError;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.Gap;
import org.dronewatch.analysis.survey.HeightSummary;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.sensor.Cause;

/** Tables of a site's coverage at several heights. */
public final class FieldTable {
    private static final String HEIGHT = "%10s";

    private FieldTable() {}

    /**
     * The fraction of the known cells that is covered at each height, and the fraction in which each cause is dominant.
     */
    public static List<String> causes(FieldSummary summary, CoverageInputs inputs) {
        Set<Cause> causes = EnumSet.noneOf(Cause.class);
        summary.heights().forEach(height -> causes.addAll(height.causes().keySet()));
        List<String> lines = new ArrayList<>();
        lines.add("in % of the known cells" + inputs.areaInWords() + " at each height" + inputs.termsInWords() + ":");
        StringBuilder header = new StringBuilder(text(HEIGHT, "height") + text("  %11s", "known cells") + "  covered");
        causes.forEach(cause -> header.append("  ").append(CoverageTable.name(cause)));
        lines.add(header.toString());
        for (HeightSummary height : summary.heights()) {
            StringBuilder line = new StringBuilder(text(HEIGHT, metres(height.height())));
            line.append(text("  %,11d", height.known())).append(text("  %7s", percent(height.covered(), height)));
            for (Cause cause : causes) {
                String cells = percent(height.causes().getOrDefault(cause, 0), height);
                line.append(text("  %" + CoverageTable.name(cause).length() + "s", cells));
            }
            lines.add(line.toString());
        }
        return lines;
    }

    /** How much of the area is unknown, and why; empty if nothing is. */
    public static Optional<String> unknownInWords(FieldSummary summary) {
        if (summary.isAllKnown()) {
            return Optional.empty();
        }
        Comparator<HeightSummary> byUnknown = Comparator.comparingInt(HeightSummary::unknown);
        String least = unknown(Collections.min(summary.heights(), byUnknown));
        String most = unknown(Collections.max(summary.heights(), byUnknown));
        String range =
                least.equals(most) ? most + " % of the area" : least + " to " + most + " % of the area, by height";
        return Optional.of(range + ": the ground there, or below a line of sight, is not known");
    }

    private static String unknown(HeightSummary height) {
        return height.unknown() == 0 ? "0" : CoverageTable.percent(height.unknown(), height.cells());
    }

    /**
     * Explains why, on the worst heading, the drone's radial speed is too low for a sensor: on that heading, a radar
     * that rejects low radial speeds detects the drone in no cell, including cells whose dominant cause is that of
     * another sensor. Empty if the radial speed is too low in no cell, or if another heading counts.
     */
    public static Optional<String> slownessInWords(FieldSummary summary, CoverageInputs inputs) {
        boolean isTooSlow =
                summary.causesBySensor().values().stream().anyMatch(causes -> causes.containsKey(Cause.TOO_SLOW));
        return isTooSlow && inputs.heading().equals("worst")
                ? Optional.of("hovering, or flying across a radar's line of sight; what is detected on other headings"
                        + " is shown by --heading best or inbound")
                : Optional.empty();
    }

    /**
     * The cells that are no longer covered without each sensor, minus those that are covered only without it, in
     * percent of the known cells at each height; a dash where no cell changes.
     */
    public static List<String> losses(FieldSummary summary, CoverageInputs inputs) {
        List<String> lines = new ArrayList<>();
        lines.add("coverage lost if one sensor is removed (lost minus gained), in % of the known cells:");
        StringBuilder header = new StringBuilder(text("%-24s", "sensor"));
        summary.heights().forEach(height -> header.append(text(HEIGHT, metres(height.height()))));
        lines.add(header.toString());
        for (String sensor : summary.coverage().field().sensors()) {
            StringBuilder line = new StringBuilder(text("%-24s", sensor));
            summary.heights().forEach(height -> line.append(text(HEIGHT, loss(height, sensor))));
            lines.add(line.toString());
        }
        List<String> idle = summary.idleSensors();
        if (!idle.isEmpty()) {
            lines.add("the same cells are covered (" + inputs.headingInWords() + ") without "
                    + (idle.size() == 1 ? "" : "any one of: ") + String.join(", ", idle));
        }
        return lines;
    }

    /** The net loss at a height: gains may cancel losses, or exceed them. */
    private static String loss(HeightSummary height, String sensor) {
        int lost = height.lost().get(sensor);
        if (lost == 0 && height.changed().get(sensor) > 0) {
            return "0.0";
        }
        return (lost < 0 ? "-" : "") + percent(Math.abs(lost), height);
    }

    /** The percentage of columns in which each sensor has a clear line of sight at or below each height. */
    public static List<String> visible(VisibleHeights visible) {
        List<Double> heights = visible.grid().heights();
        List<String> lines = new ArrayList<>();
        lines.add("clear line of sight at or below a height, in % of the area with ground:");
        StringBuilder header = new StringBuilder(text("%-24s", "sensor"));
        heights.forEach(height -> header.append(text(HEIGHT, metres(height))));
        lines.add(header.toString());
        for (int sensor = 0; sensor < visible.sensors().size(); sensor++) {
            StringBuilder line =
                    new StringBuilder(text("%-24s", visible.sensors().get(sensor)));
            for (double height : heights) {
                line.append(text(HEIGHT, percent(visible.count(sensor, height), visible.columns())));
            }
            lines.add(line.toString());
        }
        StringBuilder any = new StringBuilder(text("%-24s", "any of them"));
        heights.forEach(height -> any.append(text(HEIGHT, percent(visible.count(height), visible.columns()))));
        lines.add(any.toString());
        return lines;
    }

    /** The percentage of columns in which a sensor detects the drone at or below each height. */
    public static List<String> detectable(DetectableHeights detectable, CoverageInputs inputs) {
        StringBuilder header = new StringBuilder(text("%-24s", ""));
        StringBuilder line = new StringBuilder(text("%-24s", "detected"));
        for (double height : detectable.grid().heights()) {
            header.append(text(HEIGHT, metres(height)));
            line.append(text(HEIGHT, percent(detectable.count(height), detectable.columns())));
        }
        List<String> lines = new ArrayList<>();
        lines.add("detected at or below a height" + inputs.withProbability() + ", in % of the area with ground:");
        lines.add(header.toString().stripTrailing());
        lines.add(line.toString());
        if (detectable.coveredAgain() > 0) {
            lines.add(text(
                    "in %s %% of this area, there is a height without detection between two heights with detection;"
                            + " the largest such interval of heights is %s",
                    percent(detectable.coveredAgain(), detectable.columns()), metres(detectable.largestGap())));
        }
        return lines;
    }

    /** The largest gap at each height, with its cause. */
    public static List<String> gaps(FieldSummary summary) {
        List<String> lines = new ArrayList<>();
        lines.add("largest gap:");
        for (HeightSummary height : summary.heights()) {
            Optional<Gap> gap = height.gap();
            lines.add(text(HEIGHT, metres(height.height()))
                    + gap.map(FieldTable::words).orElse("  none"));
        }
        return lines;
    }

    /**
     * How accurate the signal levels that are interpolated between traced positions are, a line for each sensor, with a
     * warning where they are not accurate; empty if no levels are interpolated.
     */
    public static List<String> interpolated(FieldSummary summary) {
        List<String> lines = new ArrayList<>();
        summary.coverage().field().interpolated().forEach((sensor, error) -> {
            boolean isAccurate = error.percentile95() <= InterpolationError.ACCURATE;
            lines.add(text(
                    "%s'%s': levels traced at %,d positions, interpolated elsewhere; at 95 %% of %,d other positions the error is at"
                            + " most %.2f dB%s",
                    isAccurate ? "" : "warning: ",
                    sensor,
                    error.places(),
                    error.heldOut(),
                    error.percentile95(),
                    isAccurate
                            ? ""
                            : text(
                                    ", which is above the limit of %s dB: %s",
                                    Numbers.text(InterpolationError.ACCURATE), remedy(sensor, error))));
        });
        return lines;
    }

    /** The remedy that makes levels more accurate: more rays, if the errors of looks alone are too large. */
    private static String remedy(String sensor, InterpolationError error) {
        return error.percentile95OfLooks() <= InterpolationError.ACCURATE
                ? "larger cells or fewer heights help"
                : text(
                        "the random rays of a look alone cause errors of up to %.2f dB (95 %%), so only a"
                                + " larger sensors.%s.propagation.rays helps",
                        error.percentile95OfLooks(), sensor);
    }

    private static String words(Gap gap) {
        String rim = gap.touchesRim() ? "; reaches the edge of the area" : "";
        return text(
                "  %s, innermost point at x %.1f m, y %.1f m; main cause: %s%s",
                Numbers.area(gap.area()), gap.x() + 0.0, gap.y() + 0.0, cause(gap), rim);
    }

    /** A look may detect the drone, but with too low a probability, or too late. */
    private static String cause(Gap gap) {
        return gap.cause() == Cause.DETECTED ? CoverageTable.TOO_RARELY : CoverageTable.name(gap.cause());
    }

    private static String metres(double height) {
        return Numbers.text(height) + " m";
    }

    private static String percent(int cells, HeightSummary height) {
        return percent(cells, height.known());
    }

    private static String percent(int cells, int of) {
        return of == 0 ? "-" : CoverageTable.percent(cells, of);
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
