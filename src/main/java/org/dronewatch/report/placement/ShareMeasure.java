package org.dronewatch.report.placement;

import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.placement.site.SectorGain;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.report.file.Numbers;

/**
 * Describes in words the fraction of the airspace that is covered.
 *
 * @param fold number of sensors that must cover a cell
 * @param isWeighted whether some cells count more than others
 * @param headings number of headings that count alike; 1 if only that of inbound flight counts
 */
record ShareMeasure(int fold, boolean isWeighted, int headings) implements PlaceMeasure {
    private static final List<String> NUMBERS = List.of(
            "zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve");

    /** What the search counts, in the same words in all tables that state it. */
    static String mean(int headings) {
        return "averaged over " + inWords(headings) + " headings";
    }

    /** A number of headings as a word; in digits above twelve. */
    static String inWords(int headings) {
        return headings < NUMBERS.size() ? NUMBERS.get(headings) : Integer.toString(headings);
    }

    private boolean isMean() {
        return headings > 1;
    }

    @Override
    public String purpose() {
        return isMean() ? ", judged by its coverage " + mean(headings) : "";
    }

    @Override
    public String headingsClause() {
        return isMean() ? ", " + mean(headings) : "";
    }

    @Override
    public String headingsOfTable() {
        return isMean() ? "This table states the coverage " + mean(headings) + ". " : "";
    }

    @Override
    public String text(double value) {
        return FrontWords.percent(value);
    }

    @Override
    public String claim(boolean isOne, double value) {
        return (isOne ? "covers " : "cover ") + text(value);
    }

    @Override
    public String whole() {
        return " of the " + air() + (fold > 1 ? " with " + fold + " sensors or more" : "") + headingsClause();
    }

    private String air() {
        return isWeighted ? "weighted airspace" : "airspace";
    }

    @Override
    public String heading() {
        return "covered";
    }

    @Override
    public String axis() {
        return air() + " covered [%]";
    }

    @Override
    public double plotted(double value) {
        return FrontWords.PERCENT * value;
    }

    @Override
    public OptionalDouble most() {
        return OptionalDouble.of(FrontWords.PERCENT);
    }

    @Override
    public String unbeaten() {
        return "no layout covers more";
    }

    @Override
    public String columns() {
        return "'Alone' is the part of the " + air()
                + " that a sensor covers by itself, 'together' what all sensors so far cover.";
    }

    @Override
    public String gained(SectorGain gain, boolean isFirst) {
        String heights = Numbers.text(gain.lowest())
                + (gain.lowest() < gain.highest() ? " to " + Numbers.text(gain.highest()) : "");
        return (gain.isClosed() ? "closes the gap in the " : "adds most in the ") + CompassPoint.of(gain.bearing())
                + " at " + heights + " m" + FrontWords.change(isFirst, text(gain.before()), text(gain.after()));
    }
}
