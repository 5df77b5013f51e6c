package org.dronewatch.app.rendering;

import java.util.function.BooleanSupplier;
import me.tongfei.progressbar.ProgressBar;
import org.dronewatch.app.console.Progress;
import org.dronewatch.app.option.RunTime;
import org.dronewatch.render.film.Film;
import org.dronewatch.render.film.FilmFormat;
import org.dronewatch.render.film.FilmMaker;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Option;

/** The options of {@code render} for films. */
public final class FilmOptions {
    private static final int FPS = 25;

    @Option(names = "--from", paramLabel = "T", description = "Time at which a video begins, s; 0 by default.")
    private String from;

    @Option(names = "--to", paramLabel = "T", description = "Time at which a video ends, s; the run's end by default.")
    private String to;

    @Option(
            names = "--fps",
            paramLabel = "N",
            description = "Frames per second of a video, " + Film.LEAST_FPS + " to " + Film.MOST_FPS + "; " + FPS
                    + " by default.")
    private Integer fps;

    @Option(
            names = "--speed",
            paramLabel = "FACTOR",
            description = "Playback speed of a video relative to real time, 0.01 to 1000; 1 by default.")
    private Double speed;

    /** Rejects the options for films; to be called when no film is made. */
    public void checkUnused() {
        String given = from != null
                ? "--from " + from
                : to != null ? "--to " + to : fps != null ? "--fps " + fps : speed != null ? "--speed " + speed : null;
        if (given != null) {
            throw new InputException(given + ": applies only to videos (--out FILE.mp4 or FILE.gif)");
        }
    }

    /**
     * The times of a run that the film shows.
     *
     * @param duration duration of the run, s
     */
    public Film film(double duration) {
        double begin = from == null ? 0.0 : RunTime.parse("--from", from, duration);
        double end = to == null ? duration : RunTime.parse("--to", to, duration);
        if (begin > end) {
            throw new InputException(
                    "--from " + from + ": must not be after " + (to == null ? "the end of the run" : "--to " + to));
        }
        try {
            return new Film(begin, end, fps == null ? FPS : fps, speed == null ? 1.0 : speed);
        } catch (IllegalArgumentException e) {
            throw new InputException("--fps, --speed: " + e.getMessage(), e);
        }
    }

    /**
     * Writes a film, whole or not at all.
     *
     * @param isShown whether a bar shows its progress
     * @throws java.util.concurrent.CancellationException when it is interrupted
     */
    static void write(
            FilmMaker maker, WholeFile target, FilmFormat format, BooleanSupplier cancelled, boolean isShown) {
        ProgressBar bar = isShown ? Progress.barOf("video", maker.film().frames()) : null;
        try {
            target.writeFile(partial -> maker.write(
                    partial,
                    format,
                    done -> {
                        if (bar != null) {
                            bar.stepTo(done);
                        }
                    },
                    cancelled));
        } finally {
            if (bar != null) {
                bar.close();
            }
        }
    }
}
