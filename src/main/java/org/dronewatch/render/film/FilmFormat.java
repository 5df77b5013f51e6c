package org.dronewatch.render.film;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.util.Arrays;
import java.util.Optional;

/** The file format of a film. */
public enum FilmFormat {
    /** H.264, for browsers and presentations. */
    MP4("mp4") {
        @Override
        FilmEncoder encoder(FileChannel file, int fps) throws IOException {
            return new Mp4Encoder(file, fps);
        }
    },
    /**
     * An endlessly repeating animation with up to 256 colours per frame, for pages that show pictures but not videos.
     */
    GIF("gif") {
        @Override
        FilmEncoder encoder(FileChannel file, int fps) throws IOException {
            return new GifEncoder(file, fps);
        }
    };

    private final String ending;

    FilmFormat(String ending) {
        this.ending = ending;
    }

    /** The format of files with this extension, in lower case and without a dot; empty if such files are not films. */
    public static Optional<FilmFormat> ofEnding(String ending) {
        return Arrays.stream(values())
                .filter(format -> format.ending.equals(ending))
                .findFirst();
    }

    /** Begins a film in an empty file that is open for writing and reading. */
    abstract FilmEncoder encoder(FileChannel file, int fps) throws IOException;
}
