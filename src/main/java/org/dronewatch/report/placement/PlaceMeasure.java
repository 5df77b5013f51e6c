package org.dronewatch.report.placement;

import java.util.OptionalDouble;
import org.dronewatch.placement.site.SectorGain;

/** What the values of an objective are, in words. */
public interface PlaceMeasure {
    /** What the layout is best for, with a space before it: {@code  against the weakest route}; or empty. */
    String purpose();

    /** A value: {@code 95.8 %}. */
    String text(double value);

    /**
     * What sensors achieve: {@code covers 95.8 %}.
     *
     * @param isOne whether the verb is that of one subject
     */
    String claim(boolean isOne, double value);

    /** What the value is a part of, with a space before it: {@code  of the air}; or empty. */
    String whole();

    /** The heading of a column of values. */
    String heading();

    /** The title of the axis of values, with its unit. */
    String axis();

    /** A value in the unit of the axis. */
    double plotted(double value);

    /** The greatest value that there can be, in the unit of the axis; empty without a limit. */
    OptionalDouble most();

    /** What the bound says: {@code no layout covers more}. */
    String unbeaten();

    /** What the columns 'alone' and 'together' are, in a sentence. */
    String columns();

    /** Where a layout gains over another: {@code adds most in the west at 30 m (56.5 % before, 93.3 % now)}. */
    String gained(SectorGain gain);
}
