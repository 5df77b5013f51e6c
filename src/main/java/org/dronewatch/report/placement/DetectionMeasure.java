package org.dronewatch.report.placement;

import java.util.OptionalDouble;
import org.dronewatch.placement.route.RoutePlacement;
import org.dronewatch.placement.site.SectorGain;
import org.dronewatch.report.CompassPoint;

/** Describes an exposure on the weakest route in words, as the probability of a detection. */
record DetectionMeasure() implements PlaceMeasure {
    @Override
    public String purpose() {
        return ", judged by its weakest route";
    }

    @Override
    public String text(double value) {
        return FrontWords.percent(RoutePlacement.detection(value));
    }

    @Override
    public String claim(boolean isOne, double value) {
        return (isOne ? "detects" : "detect") + " the drone with a probability of " + text(value)
                + " on the weakest route past " + (isOne ? "it" : "them");
    }

    @Override
    public String whole() {
        return ", as estimated by the search";
    }

    @Override
    public String heading() {
        return "detected";
    }

    @Override
    public String axis() {
        return "probability of a detection on the weakest route [%]";
    }

    @Override
    public double plotted(double value) {
        return FrontWords.PERCENT * RoutePlacement.detection(value);
    }

    @Override
    public OptionalDouble most() {
        return OptionalDouble.of(FrontWords.PERCENT);
    }

    @Override
    public String unbeaten() {
        return "no layout does better";
    }

    @Override
    public String columns() {
        return "'Alone' is the probability that a sensor by itself detects the drone on the weakest route past it,"
                + " 'together' the same probability for all sensors so far.";
    }

    @Override
    public String gained(SectorGain gain, boolean isFirst) {
        String from = CompassPoint.of(gain.bearing());
        return (gain.isClosed()
                        ? "closes the gap in the " + from
                        : "detection on the weakest route, from the " + from + ", rises")
                + FrontWords.change(isFirst, FrontWords.percent(gain.before()), FrontWords.percent(gain.after()));
    }
}
