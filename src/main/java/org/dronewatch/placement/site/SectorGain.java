package org.dronewatch.placement.site;

/**
 * The part of the airspace in which a layout gains most over another: an eighth of the compass around its middle, at
 * some heights; or the flights or routes that come from there.
 *
 * @param bearing of the middle of the eighth, clockwise from north, rad
 * @param lowest height above the ground, m
 * @param highest height above the ground, m
 * @param before what the other layout is worth there: the fraction that it covers, its warning in s, or the probability
 *     with which it detects the drone on the weakest route
 * @param after what this layout is worth there
 */
public record SectorGain(double bearing, double lowest, double highest, double before, double after) {
    /** A part of which this fraction is covered, or a route with this probability of a detection, counts as closed. */
    private static final double CLOSED = 0.95;

    /** Whether hardly any gap remains there, unlike before; for fractions and probabilities. */
    public boolean isClosed() {
        return after >= CLOSED && before < CLOSED;
    }
}
