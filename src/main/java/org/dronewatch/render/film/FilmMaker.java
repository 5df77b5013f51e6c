package org.dronewatch.render.film;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.channels.ClosedByInterruptException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;
import java.util.function.DoubleFunction;
import java.util.function.IntConsumer;

/**
 * Makes videos of runs: MP4 files with H.264, playable in browsers and presentations, or GIF files for pages that show
 * only pictures.
 */
public final class FilmMaker {
    private final Film film;
    private final DoubleFunction<BufferedImage> pictures;

    /**
     * A film of pictures, all of the same size.
     *
     * @param pictures returns the image at a simulated time, s; called once for each frame, in order of time
     */
    public FilmMaker(Film film, DoubleFunction<BufferedImage> pictures) {
        this.film = film;
        this.pictures = pictures;
    }

    /** The start, end, frame rate and playback speed of the video. */
    public Film film() {
        return film;
    }

    /**
     * Writes the film to a file. The same pictures give the same bytes.
     *
     * @param file an empty file
     * @param format how the film is stored
     * @param progress receives the number of frames written
     * @param cancelled queried before each frame
     * @throws CancellationException once {@code cancelled} is true or the thread is interrupted; the file is then
     *     incomplete
     * @throws IllegalArgumentException when a picture is too large for a film
     * @throws IOException if writing fails
     */
    public void write(Path file, FilmFormat format, IntConsumer progress, BooleanSupplier cancelled)
            throws IOException {
        try (FileChannel channel = FileChannel.open(file, StandardOpenOption.READ, StandardOpenOption.WRITE)) {
            FilmEncoder encoder = format.encoder(channel, film.fps());
            for (int frame = 0; frame < film.frames(); frame++) {
                if (cancelled.getAsBoolean()) {
                    throw new CancellationException("the video was cancelled");
                }
                encoder.add(pictures.apply(film.time(frame)));
                progress.accept(frame + 1);
            }
            encoder.finish();
        } catch (ClosedByInterruptException e) {
            // Whoever asks a command to end interrupts what it waits for, too.
            throw new CancellationException("the video was cancelled");
        }
    }
}
