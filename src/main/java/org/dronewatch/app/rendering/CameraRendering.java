package org.dronewatch.app.rendering;

import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.OptionalInt;
import javax.imageio.ImageIO;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.render.CameraView;
import org.dronewatch.render.RunHistory;
import org.dronewatch.render.film.Film;
import org.dronewatch.render.film.FilmFormat;
import org.dronewatch.render.film.FilmMaker;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.DepthImage;
import org.dronewatch.sensor.optics.PictureSettings;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Model.CommandSpec;

/** The view of one camera. */
public final class CameraRendering extends Rendering {
    private final SceneSettings settings;
    private final String id;
    private final SensorSettings<?> camera;
    private final OptionalInt samples;

    /**
     * The view of a camera.
     *
     * @param samples rays along each axis of a pixel in a colour picture; empty for one in shades of blue
     */
    public CameraRendering(SceneSettings settings, Simulation simulation, String id, OptionalInt samples) {
        super(simulation);
        this.settings = settings;
        this.id = id;
        this.camera = settings.sensors().get(id);
        this.samples = samples;
    }

    @Override
    public void check(String ending) {
        if (samples.isPresent()
                && !camera.as(PictureSettings.class).orElseThrow().seesColour()) {
            throw new InputException("--colour: '" + id + "' (" + camera.kind() + ") does not take pictures in colour");
        }
        if (FilmFormat.ofEnding(ending).isPresent()) {
            camera.as(PictureSettings.class)
                    .ifPresent(picture -> checkFilm("--camera " + id, picture.width(), picture.height()));
        }
    }

    /**
     * {@inheritDoc} The picture shows the most recent look of a camera on a positioner, or the view from a fixed
     * mount at any time. Without a positioner or a steered drone, no simulation is needed.
     */
    @Override
    public String picture(double time, String ending, WholeFile target, ThreadsOption threads, CommandSpec spec) {
        boolean turns = Mounted.positioner(camera).isPresent();
        double shown = turns ? CameraView.lookTime(camera, time) : time;
        RunHistory history =
                turns || Simulation.isSteered(settings) ? simulation().until(shown, () -> false) : new RunHistory();
        if (turns) {
            Notes.of(spec)
                    .accept(String.format(
                            Locale.ROOT, "camera '%s' points as it did at its look at %.3f s", id, shown));
        }
        if (samples.isPresent()) {
            BufferedImage photo = threads.call(() -> view(history).photograph(shown, samples.getAsInt()));
            target.write(stream -> ImageIO.write(photo, "png", stream));
            return photo.getWidth() + " x " + photo.getHeight() + " pixels";
        }
        DepthImage image = threads.call(() -> view(history).draw(shown));
        target.write(ending.equals("png") ? image::writePng : image::writePfm);
        return image.width() + " x " + image.height() + " pixels, " + image.hitCount() + " of them on drones";
    }

    private CameraView view(RunHistory history) {
        return new CameraView(id, camera, simulation().stage(history, settings), history);
    }

    /** A film shows the looks that the camera takes in the run, each until the next. */
    @Override
    FilmMaker maker(Film film, RunHistory history) {
        CameraView view = view(history);
        double[] shown = {Double.NaN};
        BufferedImage[] image = new BufferedImage[1];
        return new FilmMaker(film, time -> {
            double look = CameraView.lookTime(camera, time);
            if (look != shown[0]) {
                shown[0] = look;
                image[0] = samples.isPresent()
                        ? view.photograph(look, samples.getAsInt())
                        : view.draw(look).toImage();
            }
            return image[0];
        });
    }
}
