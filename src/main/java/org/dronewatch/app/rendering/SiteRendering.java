package org.dronewatch.app.rendering;

import java.awt.image.BufferedImage;
import java.util.function.DoubleFunction;
import javax.imageio.ImageIO;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.render.RunHistory;
import org.dronewatch.render.film.Film;
import org.dronewatch.render.film.FilmFormat;
import org.dronewatch.render.film.FilmMaker;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Model.CommandSpec;

/** The whole site with all that is in it. */
public final class SiteRendering extends Rendering {
    private final String title;
    private final SceneSettings settings;
    private final SiteView view;
    private final SiteView.From from;

    public SiteRendering(
            String title, SceneSettings settings, Simulation simulation, SiteView view, SiteView.From from) {
        super(simulation);
        this.title = title;
        this.settings = settings;
        this.view = view;
        this.from = from;
    }

    @Override
    public void check(String ending) {
        if (ending.equals("pfm")) {
            throw new InputException("--out: a picture of the site must end in .png, a video in .mp4 or .gif");
        }
        view.check(settings);
        if (FilmFormat.ofEnding(ending).isPresent()) {
            view.checkFilm();
        }
    }

    /**
     * {@inheritDoc} The picture shows no detections, so that a scene without positioners or steered drones need not
     * be simulated.
     */
    @Override
    public String picture(double time, String ending, WholeFile target, ThreadsOption threads, CommandSpec spec) {
        boolean turns = settings.sensors().values().stream()
                .anyMatch(sensor -> Mounted.positioner(sensor).isPresent());
        RunHistory history =
                turns || Simulation.isSteered(settings) ? simulation().until(time, () -> false) : new RunHistory();
        BufferedImage image = threads.call(() -> pictures(history, time, false).apply(time));
        target.write(stream -> ImageIO.write(image, "png", stream));
        return image.getWidth() + " x " + image.getHeight() + " pixels";
    }

    @Override
    FilmMaker maker(Film film, RunHistory history) {
        return new FilmMaker(film, pictures(history, film.from(), true));
    }

    private DoubleFunction<BufferedImage> pictures(RunHistory history, double first, boolean detections) {
        Stage stage = simulation().stage(history, settings);
        return view.pictures(title, settings, stage, history, from, first, detections);
    }
}
