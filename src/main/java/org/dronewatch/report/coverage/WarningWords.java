package org.dronewatch.report.coverage;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.report.html.Html;

/** The warning of straight inbound flights in words and in a table. */
final class WarningWords {
    private final InboundWarnings warnings;

    WarningWords(InboundWarnings warnings) {
        this.warnings = warnings;
    }

    /** The section. */
    String html() {
        return Html.plain("p", introduction()) + new WarningRose(warnings).svg() + table() + range();
    }

    private String introduction() {
        return "A drone flies straight in from " + number(warnings.reach()) + " m away, at its cruise speed, to "
                + (warnings.isZone() ? "the protected zone" : "the middle of the sensors")
                + ". For each bearing from which it comes, the figure shows the time from its first detection until"
                + " it arrives; where a line touches the centre, it arrives undetected. "
                + (warnings.response() > 0.0
                        ? "From bearings where a line is inside the ring, the warning comes too late."
                        : "The scene requires no response time (alert.response).");
    }

    /** What the size of the area hides; empty where no flight is detected. */
    private String range() {
        OptionalDouble longest = longest();
        if (longest.isEmpty()) {
            return "";
        }
        String limit = String.format(
                Locale.ROOT,
                "The flights begin %s m away, so a warning of more than %s s cannot be found.",
                number(warnings.reach()),
                number(longest.getAsDouble()));
        return Html.plain(
                "p",
                limit
                        + (warnings.response() > longest.getAsDouble()
                                ? " That is less than the required response: choose a larger area (--side)."
                                : ""));
    }

    /** The longest warning that a flight that is detected at once would give, s: its speed follows from any other. */
    private OptionalDouble longest() {
        return warnings.all().stream()
                .filter(one -> one.time().isPresent() && one.range().getAsDouble() > one.arrival())
                .mapToDouble(one -> (warnings.reach() - one.arrival())
                        * one.time().getAsDouble()
                        / (one.range().getAsDouble() - one.arrival()))
                .max();
    }

    private String table() {
        List<List<String>> rows = new ArrayList<>();
        boolean isRequired = warnings.response() > 0.0;
        for (double height : WarningTable.heights(warnings)) {
            List<Warning> its = at(height);
            List<String> row = new ArrayList<>(List.of(number(height) + " m", least(its), count(its, 0.0)));
            if (isRequired) {
                row.add(count(its, warnings.response()));
            }
            rows.add(row);
        }
        List<String> head = new ArrayList<>(List.of("height", "least warning", "bearings without a warning"));
        if (isRequired) {
            head.add("bearings with less than " + number(warnings.response()) + " s");
        }
        return Html.table(head, rows);
    }

    private List<Warning> at(double height) {
        return warnings.all().stream().filter(one -> one.height() == height).toList();
    }

    private static String count(List<Warning> its, double response) {
        return its.stream().filter(one -> !one.isInTime(response)).count() + " of " + its.size();
    }

    private static String least(List<Warning> its) {
        Warning least = worst(its);
        return (least.time().isPresent() ? number(least.time().getAsDouble()) + " s" : "none") + " from the "
                + ReferencePoint.direction(least.bearing());
    }

    private static Warning worst(List<Warning> its) {
        return its.stream()
                .min(Comparator.comparingDouble(one -> one.time().orElse(-1.0)))
                .orElseThrow();
    }

    /** The worst warning of all heights, and whether all are in time. */
    String worstInWords() {
        Warning worst = worst(warnings.all());
        String zone = warnings.isZone() ? "the protected zone" : "the middle of the sensors";
        String from =
                number(worst.height()) + " m above the ground, from the " + ReferencePoint.direction(worst.bearing());
        String first = worst.time().isPresent()
                ? "The shortest warning of a straight inbound flight is "
                        + number(worst.time().getAsDouble()) + " s before it reaches " + zone + ": at " + from + "."
                : "A straight inbound flight at " + from + ", reaches " + zone + " undetected, as in "
                        + count(warnings.all(), 0.0) + " cases (bearings and heights).";
        if (warnings.response() == 0.0) {
            return first;
        }
        boolean isMet = warnings.all().stream().allMatch(one -> one.isInTime(warnings.response()));
        return first + " The required " + number(warnings.response()) + " s are "
                + (isMet
                        ? "met from every bearing at every height."
                        : "not met in " + count(warnings.all(), warnings.response()) + " cases.");
    }
}
