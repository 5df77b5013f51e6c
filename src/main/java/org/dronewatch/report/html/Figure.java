package org.dronewatch.report.html;

/**
 * A picture of the report.
 *
 * @param caption what it shows
 * @param png the picture
 */
@SuppressWarnings("ArrayRecordComponent")
public record Figure(String caption, byte[] png) {
    /** Keeps its own bytes. */
    public Figure {
        png = png.clone();
    }

    /** A copy of the picture. */
    @Override
    public byte[] png() {
        return png.clone();
    }
}
