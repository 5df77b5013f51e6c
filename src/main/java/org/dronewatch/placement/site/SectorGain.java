package org.dronewatch.placement.site;

/**
 * The part of the airspace in which a layout gains the most over another: a compass sector of 45 degrees around the
 * centre of the airspace, at some heights; or the flights or routes that come from that sector.
 *
 * @param bearing bearing of the centre of the sector, clockwise from north, rad
 * @param lowest lowest height above the ground, m
 * @param highest highest height above the ground, m
 * @param before what the other layout is worth there: the fraction that it covers, its warning time in s, or the
 *     probability with which it detects the drone on the weakest route
 * @param after what this layout is worth there
 */
public record SectorGain(double bearing, double lowest, double highest, double before, double after) {
    /** A part of which this fraction is covered, or a route with this probability of a detection, counts as closed. */
    private static final double CLOSED = 0.95;

    /** A covered fraction, or a probability of a detection, below this counts as a gap. */
    private static final double OPEN = 0.8;

    /**
     * Whether this layout leaves hardly any gap where the other one leaves one; meaningful for fractions and
     * probabilities only, not for warning times.
     */
    public boolean isClosed() {
        return after >= CLOSED && before < OPEN;
    }
}
