package org.dronewatch.render.film;

import java.awt.image.BufferedImage;
import java.io.IOException;

/** Encodes images as a film. The same images give the same bytes. Not thread-safe. */
interface FilmEncoder {
    /**
     * Adds a frame; all have the size of the first.
     *
     * @throws IllegalArgumentException when a side has more than {@link Film#LONGEST_SIDE} pixels
     */
    void add(BufferedImage image) throws IOException;

    /** Ends the film. */
    void finish() throws IOException;
}
