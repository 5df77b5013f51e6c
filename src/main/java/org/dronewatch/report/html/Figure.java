package org.dronewatch.report.html;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import javax.imageio.ImageIO;

/**
 * A figure of a report.
 *
 * @param caption what it shows
 * @param png the image as PNG
 */
@SuppressWarnings("ArrayRecordComponent")
public record Figure(String caption, byte[] png) {
    /** Copies the bytes. */
    public Figure {
        png = png.clone();
    }

    /** A picture as a figure. */
    public static Figure of(String caption, BufferedImage image) throws IOException {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(image, "png", png);
        return new Figure(caption, png.toByteArray());
    }

    /** A copy of the image. */
    @Override
    public byte[] png() {
        return png.clone();
    }
}
