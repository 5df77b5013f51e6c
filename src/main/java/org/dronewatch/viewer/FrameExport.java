package org.dronewatch.viewer;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleFunction;
import java.util.function.IntConsumer;
import javax.imageio.ImageIO;
import org.dronewatch.report.file.WholeFile;

/** Writes a run as numbered images, which any video program can turn into a video. */
final class FrameExport {
    private final Path directory;
    private final double duration;
    private final double rate;
    private final DoubleFunction<BufferedImage> pictures;

    /**
     * An export.
     *
     * @param directory where the images are written; it must exist
     * @param duration duration of the run, s
     * @param rate images per simulated second
     * @param pictures returns the image at a time
     */
    FrameExport(Path directory, double duration, double rate, DoubleFunction<BufferedImage> pictures) {
        this.directory = directory;
        this.duration = duration;
        this.rate = rate;
        this.pictures = pictures;
    }

    /** Number of images. */
    int count() {
        return (int) Math.floor(duration * rate + 1e-9) + 1;
    }

    /**
     * Writes the images.
     *
     * @param progress receives how many are written
     * @param cancelled queried before each image: once it is true, the rest are left out
     * @return how many were written
     */
    int write(IntConsumer progress, BooleanSupplier cancelled) {
        int written = 0;
        while (written < count() && !cancelled.getAsBoolean()) {
            BufferedImage picture = pictures.apply(written / rate);
            Path file = directory.resolve(String.format(Locale.ROOT, "frame-%05d.png", written));
            new WholeFile("picture", file.toString()).write(stream -> ImageIO.write(picture, "png", stream));
            written++;
            progress.accept(written);
        }
        return written;
    }
}
