package org.dronewatch.analysis.field;

import java.util.Optional;
import org.dronewatch.sensor.Cause;

/**
 * A gap in the coverage at one height: cells that no sensor covers, each adjacent to another along an edge.
 *
 * @param cells number of its cells
 * @param area m2
 * @param x east coordinate of its innermost cell's middle, m: the cell of the gap farthest from everything else, the
 *     first from the north-west among equals
 * @param y north coordinate of the same cell, m
 * @param cause the most frequent dominant cause in it, and the one nearest to a detection among equals
 * @param touchesRim whether it reaches the rim of the grid: it may continue outside
 */
public record Gap(int cells, double area, double x, double y, Cause cause, boolean touchesRim) {

    /** The largest gap at a height, given by its number; the first from the north-west among equals; empty if none. */
    public static Optional<Gap> largest(FieldCoverage coverage, int height) {
        return new GapSearch(coverage, height).largest();
    }
}
