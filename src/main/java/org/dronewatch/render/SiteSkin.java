package org.dronewatch.render;

/**
 * An overlay (skin) of colours on whatever faces up on a site: ground, floors and roofs. Must be safe for use by
 * several threads.
 */
@FunctionalInterface
public interface SiteSkin {
    /**
     * The colour of a point of the site.
     *
     * @param east coordinate of the point to the east, m
     * @param north coordinate of the point to the north, m
     * @param column column of the pixel that shows the point, in a picture of normal density; lets the colours form
     *     patterns
     * @param row row of that pixel
     * @param below the colour without the skin: red, green and blue in the lowest 24 bits
     * @return the colour with the skin; {@code below} where the skin has no colour
     */
    int colour(double east, double north, int column, int row, int below);
}
