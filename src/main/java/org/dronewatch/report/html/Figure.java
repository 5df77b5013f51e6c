package org.dronewatch.report.html;

/**
 * A figure of the report.
 *
 * @param caption what it shows
 * @param png the image
 */
@SuppressWarnings("ArrayRecordComponent")
public record Figure(String caption, byte[] png) {
    /** Copies the bytes. */
    public Figure {
        png = png.clone();
    }

    /** A copy of the image. */
    @Override
    public byte[] png() {
        return png.clone();
    }
}
