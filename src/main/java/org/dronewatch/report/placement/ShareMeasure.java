package org.dronewatch.report.placement;

import java.util.OptionalDouble;
import org.dronewatch.placement.site.SectorGain;
import org.dronewatch.report.CompassPoint;
import org.dronewatch.report.file.Numbers;

/**
 * The fraction of the airspace that is covered, in words.
 *
 * @param fold number of sensors that must cover a cell
 * @param isWeighted whether some cells count more than others
 * @param isMean whether all headings count alike, and not only that of inbound flight
 */
record ShareMeasure(int fold, boolean isWeighted, boolean isMean) implements PlaceMeasure {
    /** What the search counts, in the same words in all tables that state it. */
    static final String MEAN = "averaged over eight headings";

    @Override
    public String purpose() {
        return isMean ? ", judged by its coverage " + MEAN : "";
    }

    @Override
    public String average() {
        return isMean ? ", " + MEAN : "";
    }

    @Override
    public String basis() {
        return isMean ? "This table states the coverage " + MEAN + ". " : "";
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
        return " of the " + air() + (fold > 1 ? " with " + fold + " sensors or more" : "") + average();
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
