package org.dronewatch.report.placement;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.placement.SearchEnd;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.placement.site.TimeStop;
import org.dronewatch.report.file.Numbers;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** What a time limit has stopped, for people and for {@code place.json}. */
final class TimeStopWords {
    private TimeStopWords() {}

    /**
     * In sentences: whether the layout has reached the gap, whether cheaper layouts were sought, and what else was left
     * out.
     */
    static String sentences(TimeStop stop) {
        List<String> sentences = new ArrayList<>();
        String limit = "the time limit of " + Quantity.DURATION.inWords(stop.seconds());
        String gap = "the gap of " + Numbers.text(FrontWords.PERCENT * stop.gap()) + " %";
        if (!stop.gapReached()) {
            sentences.add("T" + limit.substring(1) + " ended the search for this layout before it reached " + gap
                    + (stop.cheaper() ? "; cheaper layouts were not sought." : "."));
        } else if (stop.cheaper()) {
            sentences.add("The layout for the whole budget reached " + gap + "; " + limit
                    + " ended the search for cheaper layouts.");
        }
        if (!stop.leftOut().isEmpty()) {
            sentences.add(Quantity.DURATION.inWords(SearchEnd.FOLLOW_UP) + " after " + limit
                    + ", the command had not completed "
                    + PlainText.list(
                            stop.leftOut().stream().map(TimeStopWords::words).toList())
                    + ".");
        }
        return String.join(" ", sentences);
    }

    private static String words(LeftOut part) {
        return switch (part) {
            case COVERAGE -> "the coverage of the layout at each height";
            case WARNINGS -> "the warning times of the layout at each height";
            case PARTS -> "the figures of single sensors and the order of purchase";
            case FLIGHTS -> "the flights along the weakest routes";
            case ATTACKS -> "the attacks";
        };
    }

    /** Adds what a time limit has stopped, as figures. */
    static void add(ObjectNode root, TimeStop stop) {
        ObjectNode stopped = root.putObject("stopped");
        stopped.put("time_limit_s", Numbers.rounded(stop.seconds()));
        stopped.put("gap_asked", Numbers.rounded(stop.gap()));
        stopped.put("gap_reached", stop.gapReached());
        stopped.put("cheaper", stop.cheaper());
        ArrayNode leftOut = stopped.putArray("left_out");
        stop.leftOut().forEach(part -> leftOut.add(part.name().toLowerCase(Locale.ROOT)));
    }
}
