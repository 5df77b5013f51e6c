package org.dronewatch.placement.site;

/**
 * The part of the airspace in which a layout gains most over another: an eighth of the compass around its middle,
 * at some heights.
 *
 * @param bearing of the middle of the eighth, clockwise from north, rad
 * @param lowest height above the ground, m
 * @param highest height above the ground, m
 * @param before fraction of this part that the other layout covers
 * @param after fraction that this layout covers
 */
public record SectorGain(double bearing, double lowest, double highest, double before, double after) {
    /** A part of which this fraction is covered counts as closed. */
    private static final double CLOSED = 0.95;

    /** Whether hardly any of this part remains uncovered, unlike before. */
    public boolean isClosed() {
        return after >= CLOSED && before < CLOSED;
    }
}
