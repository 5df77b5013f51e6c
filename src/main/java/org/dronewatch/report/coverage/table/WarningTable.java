package org.dronewatch.report.coverage.table;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.DoubleFunction;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.report.file.Numbers;

/** A table of the warning times of inbound flights. */
public final class WarningTable {
    private static final String AT_LEAST = ">= ";
    private static final String FROM_OTHERS = " from the others";

    private WarningTable() {}

    /**
     * For each height, the shortest warning time and its bearing, the median, and how many bearings give no warning, or
     * one that comes too late.
     *
     * @param covered the probability with which a sensor must detect the drone, 0.008 to 0.996, or 1
     */
    public static List<String> lines(InboundWarnings warnings, double covered) {
        boolean isRequired = warnings.response() > 0.0;
        List<String> lines = new ArrayList<>();
        lines.add(text(
                "warning of drones that fly straight in from %s: time from the first detection%s until they reach %s:",
                "a distance of " + Numbers.text(warnings.reach()) + " m",
                CoverageInputs.withProbability(covered),
                warnings.isZone() ? "the protected zone" : "the centroid of the sensors"));
        lines.add(text("%10s  %34s  %10s  %14s", "height", "shortest", "median", "not detected")
                + (isRequired ? text("  %24s", "less than " + Numbers.text(warnings.response()) + " s") : ""));
        for (double height : heights(warnings)) {
            List<Warning> its = warnings.all().stream()
                    .filter(one -> one.height() == height)
                    .toList();
            String line = text(
                    "%10s  %34s  %10s  %14s",
                    Numbers.text(height) + " m",
                    least(its),
                    median(its),
                    bearings(its.stream().filter(one -> one.time().isEmpty()).count(), its.size()));
            long late =
                    its.stream().filter(one -> one.isLate(warnings.response())).count();
            lines.add(line + (isRequired ? text("  %24s", bearings(late, its.size())) : ""));
        }
        lines.addAll(open(warnings));
        return lines;
    }

    /** The heights, from the lowest to the highest, m. */
    public static double[] heights(InboundWarnings warnings) {
        return warnings.all().stream().mapToDouble(Warning::height).distinct().toArray();
    }

    /** The shortest warning time, with its bearings. */
    public static String least(List<Warning> warnings) {
        return least(LeastWarning.of(warnings, WarningTable::seconds), warnings);
    }

    private static String least(LeastWarning least, List<Warning> warnings) {
        String time = least.isNone() ? "none" : (least.isFromStart() ? AT_LEAST : "") + least.time();
        return time + " " + least.bearings(warnings);
    }

    /**
     * The shortest warning time, with its bearings, and, if some bearings give no warning, the shortest warning time
     * over the other bearings.
     */
    public static String leastAndOthers(List<Warning> warnings) {
        return leastAndOthers(warnings, WarningTable::seconds);
    }

    /**
     * The shortest warning time in words, as {@link #leastAndOthers(List)} gives it, but with times in a given format.
     *
     * @param words formats a time, s
     */
    public static String leastAndOthers(List<Warning> warnings, DoubleFunction<String> words) {
        LeastWarning least = LeastWarning.of(warnings, words);
        String text = least(least, warnings);
        return LeastWarning.ofOthers(warnings, words)
                .map(time -> least.isNoneExcept(warnings) ? text + ": " + time : text + ", " + time + FROM_OTHERS)
                .orElse(text);
    }

    /** A time in seconds, to a tenth. */
    public static String seconds(double time) {
        return text("%.1f s", time);
    }

    /** The lower one of two in the middle; those without a detection count as the least. */
    private static String median(List<Warning> warnings) {
        List<Warning> sorted = warnings.stream()
                .sorted(Comparator.comparingDouble(one -> one.time().orElse(-1.0)))
                .toList();
        List<Warning> lower = sorted.subList(0, (sorted.size() - 1) / 2 + 1);
        OptionalDouble middle = lower.get(lower.size() - 1).time();
        String from = lower.stream().anyMatch(Warning::isFromStart) ? AT_LEAST : "";
        return middle.isEmpty() ? "none" : from + seconds(middle.getAsDouble());
    }

    /** What the distance at which flights begin leaves open; empty if nothing. */
    private static List<String> open(InboundWarnings warnings) {
        List<String> lines = new ArrayList<>();
        if (warnings.all().stream().anyMatch(Warning::isFromStart)) {
            lines.add(AT_LEAST + "... : detected where the flight begins, or where the known ground begins");
        }
        if (warnings.undecided() > 0) {
            lines.add("unknown whether a warning of " + Numbers.text(warnings.response()) + " s is given: "
                    + warnings.undecided() + " of " + warnings.all().size() + " flights, which begin too near");
        }
        return lines;
    }

    private static String bearings(long count, int of) {
        return count == 0 ? "-" : count + " of " + of + " bearings";
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
