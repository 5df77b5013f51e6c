package org.dronewatch.report.placement;

import java.util.OptionalDouble;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.placement.plan.AirSettings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.WarningMeasure;
import org.dronewatch.placement.site.SectorGain;

/**
 * Describes the values of an objective in words. A value is a fraction of the airspace, 0 to 1; a warning time, s; or
 * the exposure on the weakest route, on which the drone is detected with a probability of 1 - exp(-exposure).
 */
public interface PlaceMeasure {
    /** The measure of a plan's objective. */
    static PlaceMeasure of(PlacePlan plan) {
        return switch (plan.settings().objective()) {
            case COVERAGE ->
                new ShareMeasure(
                        plan.settings().conditions().fold(),
                        !plan.settings().air().weights().isEmpty(),
                        plan.settings().air().heading() == AirSettings.Heading.ANY ? Course.COMPASS_POINTS : 1);
            case WARNING_TIME -> new SecondsMeasure(plan.settings().warning() == WarningMeasure.WORST);
            case WEAKEST_ROUTE -> new DetectionMeasure();
        };
    }

    /**
     * The criterion by which the layout is judged, as the end of a phrase: {@code , judged by its weakest route}; or an
     * empty text.
     */
    String purpose();

    /** Over which headings a value is averaged, as the end of a sentence about the value; or an empty text. */
    default String headingsClause() {
        return "";
    }

    /** The headings on which the values of a table are based, as a sentence followed by a space; or an empty text. */
    default String headingsOfTable() {
        return "";
    }

    /** A value as text: {@code 95.8 %}. */
    String text(double value);

    /**
     * What sensors achieve: {@code covers 95.8 %}.
     *
     * @param isOne whether the subject of the verb is singular
     */
    String claim(boolean isOne, double value);

    /** What the value is a fraction of, or how it was found: {@code  of the airspace}; or an empty text. */
    String whole();

    /** The heading of a column of values. */
    String heading();

    /** The title of the axis of values, with its unit. */
    String axis();

    /** A value converted to the unit of the axis. */
    double plotted(double value);

    /** The greatest possible value, in the unit of the axis; empty if there is no limit. */
    OptionalDouble most();

    /** What the upper bound means, as a clause: {@code no layout covers more}. */
    String unbeaten();

    /** A sentence that explains the columns 'alone' and 'together'. */
    String columns();

    /**
     * Where a layout gains most over another: {@code adds most in the west at 30 m (56.5 % before, 93.3 % now)}.
     *
     * @param isFirst whether the layout is the cheapest, which is compared with the kept sensors alone
     */
    String gained(SectorGain gain, boolean isFirst);
}
