package org.dronewatch.app;

import java.awt.image.BufferedImage;
import javax.imageio.ImageIO;
import org.dronewatch.render.Film;
import org.dronewatch.render.FilmMaker;
import org.dronewatch.render.RunHistory;
import org.dronewatch.report.WholeFile;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Model.CommandSpec;

/** The whole site with all that is in it. */
final class SiteRendering extends Rendering {
    private final String title;
    private final SceneRunner runner;
    private final SceneSettings settings;
    private final SiteView view;
    private final SiteView.From from;

    SiteRendering(
            String title,
            SceneRunner runner,
            SceneSettings settings,
            Simulation simulation,
            SiteView view,
            SiteView.From from) {
        super(simulation);
        this.title = title;
        this.runner = runner;
        this.settings = settings;
        this.view = view;
        this.from = from;
    }

    @Override
    void check(String ending) {
        if (ending.equals("pfm")) {
            throw new InputException("--out: a picture of the site must end in .png, a film in .mp4");
        }
        view.check(settings);
        if (ending.equals("mp4")) {
            view.checkFilm();
        }
    }

    /** Without detections: a scene without positioners is not simulated for a picture. */
    @Override
    String picture(double time, String ending, WholeFile target, ThreadsOption threads, CommandSpec spec) {
        boolean turns = settings.sensors().values().stream()
                .anyMatch(sensor -> sensor.positioner().isPresent());
        RunHistory history = turns ? simulation().until(time, () -> false) : new RunHistory();
        BufferedImage image =
                threads.call(() -> view.pictures(title, settings, runner.stage(settings), history, from, time, false)
                        .apply(time));
        target.write(stream -> ImageIO.write(image, "png", stream));
        return image.getWidth() + " x " + image.getHeight() + " pixels";
    }

    @Override
    FilmMaker maker(Film film, RunHistory history) {
        return new FilmMaker(
                film, view.pictures(title, settings, runner.stage(settings), history, from, film.from(), true));
    }
}
