package org.dronewatch.app.rendering;

import java.util.Locale;
import java.util.function.BooleanSupplier;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.render.RunHistory;
import org.dronewatch.render.film.Film;
import org.dronewatch.render.film.FilmFormat;
import org.dronewatch.render.film.FilmMaker;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Model.CommandSpec;

/** One subject of {@code render}, drawn as a picture or as a film. */
public abstract class Rendering {
    private final Simulation simulation;

    Rendering(Simulation simulation) {
        this.simulation = simulation;
    }

    /**
     * Checks the options before anything is loaded.
     *
     * @param ending extension of the picture's or film's file name
     */
    public abstract void check(String ending);

    /**
     * Draws a picture of the subject at one time, and returns a description of the picture.
     *
     * @param time seconds since the start of the run
     * @param ending extension of the picture's file name
     */
    public abstract String picture(
            double time, String ending, WholeFile target, ThreadsOption threads, CommandSpec spec);

    /** The maker of the subject's pictures over a run whose history is known up to the film's end. */
    abstract FilmMaker maker(Film film, RunHistory history);

    Simulation simulation() {
        return simulation;
    }

    /**
     * Makes a film of the subject, and returns a description of the film.
     *
     * @param cancelled queried repeatedly: once it is true, there is no film
     * @throws java.util.concurrent.CancellationException when the film is abandoned
     */
    public final String film(
            Film film, WholeFile target, FilmFormat format, ThreadsOption threads, BooleanSupplier cancelled) {
        RunHistory history = simulation.until(film.to(), cancelled);
        threads.call(() -> {
            FilmOptions.write(maker(film, history), target, format, cancelled, simulation.hasBars());
            return null;
        });
        return String.format(
                Locale.ROOT,
                "%s, %d per second, from %.2f s to %.2f s",
                Counted.of(film.frames(), "frame"),
                film.fps(),
                film.from(),
                film.time(film.frames() - 1));
    }

    /** Refuses a size that no film has. */
    static void checkFilm(String option, int width, int height) {
        try {
            Film.checkSize(width, height);
        } catch (IllegalArgumentException e) {
            throw new InputException(option + ": " + e.getMessage(), e);
        }
    }
}
