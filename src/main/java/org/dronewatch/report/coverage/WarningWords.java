package org.dronewatch.report.coverage;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.report.coverage.table.LeastWarning;
import org.dronewatch.report.coverage.table.WarningTable;
import org.dronewatch.report.html.Html;

/** States the warning times of straight inbound flights in words and in a table. */
public final class WarningWords {
    private final InboundWarnings warnings;

    /** The words for the warning times of inbound flights. */
    public WarningWords(InboundWarnings warnings) {
        this.warnings = warnings;
    }

    /** The section of a report. */
    public String html() {
        return Html.plain("p", introduction()) + new WarningRose(warnings).svg() + table() + range();
    }

    private String introduction() {
        return "A drone flies straight in from " + number(warnings.reach()) + " m away, at its cruise speed, to "
                + (warnings.isZone() ? "the protected zone" : "the centroid of the sensors")
                + ". For each bearing from which it comes, the figure shows the time from its first detection until"
                + " it arrives; where a line touches the centre, the drone arrives undetected. "
                + (warnings.response() > 0.0
                        ? "For bearings at which a line is inside the ring, the warning comes too late."
                        : "The scene states no response time (alert.response).");
    }

    /** What the distance at which flights begin hides. */
    private String range() {
        String limit = String.format(
                Locale.ROOT,
                "The flights begin %s m away, so no warning can exceed %s s.",
                number(warnings.reach()),
                number(warnings.longest()));
        boolean isShort = warnings.longest() < warnings.response();
        return Html.plain(
                "p",
                limit
                        + (isShort
                                ? " That is less than the response takes: the model of the site ends there, or the"
                                        + " flights have reached their maximum number of cells. Use a model of a larger"
                                        + " site, or larger cells (--cell)."
                                : "")
                        + (warnings.all().stream().anyMatch(Warning::isFromStart)
                                ? " If the drone is detected where its flight or the known ground begins, the"
                                        + " warning is at least as long as stated."
                                : ""));
    }

    private String table() {
        List<List<String>> rows = new ArrayList<>();
        boolean isRequired = warnings.response() > 0.0;
        for (double height : WarningTable.heights(warnings)) {
            List<Warning> its = at(height);
            List<String> row = new ArrayList<>(List.of(number(height) + " m", inTable(its), undetected(its)));
            if (isRequired) {
                row.add(late(its));
            }
            rows.add(row);
        }
        List<String> head = new ArrayList<>(List.of("height", "shortest warning", "bearings without a warning"));
        if (isRequired) {
            head.add("bearings with less than " + number(warnings.response()) + " s");
        }
        return Html.table(head, rows);
    }

    private List<Warning> at(double height) {
        return warnings.all().stream().filter(one -> one.height() == height).toList();
    }

    private static String share(long count, List<Warning> its) {
        return count + " of " + its.size();
    }

    private static String undetected(List<Warning> its) {
        return share(its.stream().filter(one -> one.time().isEmpty()).count(), its);
    }

    private String late(List<Warning> its) {
        return share(its.stream().filter(one -> one.isLate(warnings.response())).count(), its);
    }

    private static LeastWarning least(List<Warning> its) {
        return LeastWarning.of(its, WarningWords::seconds);
    }

    private static String time(LeastWarning least) {
        return (least.isFromStart() ? "at least " : "") + least.time();
    }

    private static String seconds(double time) {
        return number(time) + " s";
    }

    /** The shortest warning for the table, where the next column states how many bearings have no warning. */
    private static String inTable(List<Warning> its) {
        LeastWarning least = least(its);
        return least.isNone()
                ? WarningTable.leastAndOthers(its, WarningWords::seconds)
                : time(least) + " from " + least.directions();
    }

    /** The shortest warning time over all heights, and whether all warnings are in time, in sentences. */
    public String worstInWords() {
        LeastWarning worst = least(warnings.all());
        String zone = warnings.isZone() ? "the protected zone" : "the centroid of the sensors";
        String cases = share(worst.flights().size(), warnings.all()) + " combinations of bearing and height";
        double height = worst.flights().get(0).height();
        String first;
        if (worst.isNone()) {
            first = "A straight inbound flight at " + number(height) + " m above the ground, from the "
                    + CompassPoint.of(worst.flights().get(0).bearing()) + ", reaches " + zone
                    + " undetected; this happens in " + cases + ".";
        } else {
            boolean isOneHeight = worst.flights().stream().allMatch(one -> one.height() == height);
            first = "The shortest warning of a straight inbound flight comes " + time(worst) + " before it reaches "
                    + zone
                    + (isOneHeight
                            ? ": at " + number(height) + " m above the ground, from "
                                    + least(at(height)).directions() + "."
                            : "; this happens in " + cases + ".");
        }
        return first + (warnings.response() > 0.0 ? required() : "");
    }

    private String required() {
        String required = " The required warning of " + number(warnings.response()) + " s is ";
        long late = warnings.late();
        long undecided = warnings.undecided();
        if (late == 0 && undecided == 0) {
            return required + "given for every bearing at every height.";
        }
        String isLate = late > 0 ? required + "not given in " + share(late, warnings.all()) + " cases." : "";
        return undecided == 0
                ? isLate
                : isLate + " In " + share(undecided, warnings.all()) + " cases, it is unknown whether "
                        + (late > 0 ? "it" : "the required warning of " + number(warnings.response()) + " s")
                        + " is given: the drone is detected where its flight or the known ground begins.";
    }
}
