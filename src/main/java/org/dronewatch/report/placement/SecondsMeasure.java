package org.dronewatch.report.placement;

import java.util.OptionalDouble;
import org.dronewatch.placement.site.SectorGain;
import org.dronewatch.report.CompassPoint;

/**
 * Describes a warning time in words.
 *
 * @param isWorst whether the shortest warning counts, and not the mean
 */
record SecondsMeasure(boolean isWorst) implements PlaceMeasure {
    @Override
    public String purpose() {
        return " for the longest " + (isWorst ? "minimum" : "mean") + " warning";
    }

    @Override
    public String text(double value) {
        return PlaceTable.text("%.1f s", value);
    }

    @Override
    public String claim(boolean isOne, double value) {
        return (isOne ? "gives" : "give") + (isWorst ? " a minimum warning of " : " a mean warning of ") + text(value);
    }

    @Override
    public String whole() {
        return "";
    }

    @Override
    public String heading() {
        return "warning";
    }

    @Override
    public String axis() {
        return (isWorst ? "minimum" : "mean") + " warning [s]";
    }

    @Override
    public double plotted(double value) {
        return value;
    }

    @Override
    public OptionalDouble most() {
        return OptionalDouble.empty();
    }

    @Override
    public String unbeaten() {
        return "no layout gives a longer one";
    }

    @Override
    public String columns() {
        return "'Alone' is the warning that a sensor gives by itself, 'together' that of all sensors so far.";
    }

    @Override
    public String gained(SectorGain gain, boolean isFirst) {
        String times = FrontWords.change(isFirst, text(gain.before()), text(gain.after()));
        return isWorst
                ? "lengthens the minimum warning, from the " + CompassPoint.of(gain.bearing()) + times
                : "adds most from the " + CompassPoint.of(gain.bearing()) + times;
    }
}
