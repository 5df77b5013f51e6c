package org.dronewatch.render;

/**
 * Colours that are laid over whatever faces up on a site: ground, floors and roofs. Must be safe for use by several
 * threads.
 */
@FunctionalInterface
public interface SiteSkin {
    /**
     * The colour of a point of the site.
     *
     * @param east its coordinate, m
     * @param north its coordinate, m
     * @param column of the pixel that shows it, in a picture of normal density, so that the colours may form patterns
     * @param row of that pixel
     * @param below the colour without the skin: red, green and blue in the lowest 24 bits
     * @return the colour with the skin; {@code below} where the skin has none
     */
    int colour(double east, double north, int column, int row, int below);
}
