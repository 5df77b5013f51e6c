package org.dronewatch.report.placement;

import org.dronewatch.placement.site.TimeStop;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.setting.Quantity;
import tools.jackson.databind.node.ObjectNode;

/** What a time limit has stopped, for people and for {@code place.json}. */
final class TimeStopWords {
    private TimeStopWords() {}

    /** In a sentence: whether the layout has reached the gap, and whether cheaper layouts were sought. */
    static String sentence(TimeStop stop) {
        String limit = "the time limit of " + Quantity.DURATION.inWords(stop.seconds());
        String gap = "the gap of " + Numbers.text(FrontWords.PERCENT * stop.gap()) + " %";
        if (stop.gapReached()) {
            return "The layout for the whole budget reached " + gap + "; " + limit
                    + " ended the search for cheaper layouts.";
        }
        return "T" + limit.substring(1) + " ended the search for this layout before it reached " + gap
                + (stop.cheaper() ? "; cheaper layouts were not sought." : ".");
    }

    /** Adds the same as figures. */
    static void add(ObjectNode root, TimeStop stop) {
        ObjectNode stopped = root.putObject("stopped");
        stopped.put("time_limit_s", Numbers.rounded(stop.seconds()));
        stopped.put("gap_asked", Numbers.rounded(stop.gap()));
        stopped.put("gap_reached", stop.gapReached());
        stopped.put("cheaper", stop.cheaper());
    }
}
