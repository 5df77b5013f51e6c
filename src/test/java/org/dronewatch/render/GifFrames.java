package org.dronewatch.render;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/** Plays a GIF back. */
public final class GifFrames {
    private GifFrames() {}

    /** All its frames as they are seen: each painted over those before, as browsers do. */
    public static List<BufferedImage> of(Path file) throws IOException {
        ImageReader reader = ImageIO.getImageReadersByFormatName("gif").next();
        try (ImageInputStream in = ImageIO.createImageInputStream(file.toFile())) {
            reader.setInput(in);
            List<BufferedImage> frames = new ArrayList<>();
            for (int i = 0; i < reader.getNumImages(true); i++) {
                BufferedImage change = reader.read(i);
                BufferedImage frame =
                        new BufferedImage(change.getWidth(), change.getHeight(), BufferedImage.TYPE_INT_RGB);
                Graphics2D g = frame.createGraphics();
                if (i > 0) {
                    g.drawImage(frames.get(i - 1), 0, 0, null);
                }
                g.drawImage(change, 0, 0, null);
                g.dispose();
                frames.add(frame);
            }
            return frames;
        } finally {
            reader.dispose();
        }
    }
}
