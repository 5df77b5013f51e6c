package org.dronewatch.report.coverage;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.report.Numbers;

/** A table of the warning of inbound flights. */
public final class WarningTable {
    private WarningTable() {}

    /** For each height the least warning and its bearing, the median, and how many bearings give none or too little. */
    public static List<String> lines(InboundWarnings warnings) {
        boolean isRequired = warnings.response() > 0.0;
        List<String> lines = new ArrayList<>();
        lines.add(text(
                "warning of drones that fly straight in from %s: time from the first detection until they reach %s:",
                "a distance of " + Numbers.text(warnings.reach()) + " m",
                warnings.isZone() ? "the protected zone" : "the middle of the sensors"));
        lines.add(text("%10s  %16s  %10s  %12s", "height", "least", "median", "not detected")
                + (isRequired ? text("  %24s", "less than " + Numbers.text(warnings.response()) + " s") : ""));
        for (double height : heights(warnings)) {
            List<Warning> its = warnings.all().stream()
                    .filter(one -> one.height() == height)
                    .toList();
            String line = text(
                    "%10s  %16s  %10s  %12s",
                    Numbers.text(height) + " m",
                    least(its),
                    median(its),
                    bearings(its.stream().filter(one -> one.time().isEmpty()).count(), its.size()));
            long late = its.stream()
                    .filter(one -> !one.isInTime(warnings.response()))
                    .count();
            lines.add(line + (isRequired ? text("  %24s", bearings(late, its.size())) : ""));
        }
        return lines;
    }

    /** The heights, from the lowest to the highest. */
    static double[] heights(InboundWarnings warnings) {
        return warnings.all().stream().mapToDouble(Warning::height).distinct().toArray();
    }

    /** The least warning, with its bearing; the first bearing from north among equals. */
    static String least(List<Warning> warnings) {
        Warning least = warnings.stream()
                .min(Comparator.comparingDouble(one -> one.time().orElse(-1.0)))
                .orElseThrow();
        String from = text(" from %.0f deg", Math.toDegrees(least.bearing()));
        return (least.time().isPresent() ? text("%.1f s", least.time().getAsDouble()) : "none") + from;
    }

    /** The lower one of two in the middle; those without a detection count as the least. */
    private static String median(List<Warning> warnings) {
        double[] times = warnings.stream()
                .mapToDouble(one -> one.time().orElse(-1.0))
                .sorted()
                .toArray();
        double middle = times[(times.length - 1) / 2];
        return middle < 0.0 ? "none" : text("%.1f s", middle);
    }

    private static String bearings(long count, int of) {
        return count == 0 ? "-" : count + " of " + of + " bearings";
    }

    private static String text(String pattern, Object... values) {
        return String.format(Locale.ROOT, pattern, values);
    }
}
