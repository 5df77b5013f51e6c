package org.dronewatch.app;

import java.awt.image.BufferedImage;
import org.dronewatch.render.CameraView;
import org.dronewatch.render.Film;
import org.dronewatch.render.FilmMaker;
import org.dronewatch.render.RunHistory;
import org.dronewatch.report.WholeFile;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.DepthImage;
import org.dronewatch.sensor.optics.PictureSettings;
import picocli.CommandLine.Model.CommandSpec;

/** The view of one camera. */
final class CameraRendering extends Rendering {
    private final SceneSettings settings;
    private final String id;
    private final SensorSettings<?> camera;

    CameraRendering(SceneSettings settings, Simulation simulation, String id) {
        super(simulation);
        this.settings = settings;
        this.id = id;
        this.camera = settings.sensors().get(id);
    }

    @Override
    void check(String ending) {
        if (ending.equals("mp4")) {
            camera.as(PictureSettings.class)
                    .ifPresent(picture -> checkFilm("--camera " + id, picture.width(), picture.height()));
        }
    }

    /** A camera on a positioner shows its last look; one on a fixed mount any time, without a simulation. */
    @Override
    String picture(double time, String ending, WholeFile target, ThreadsOption threads, CommandSpec spec) {
        boolean turns = Mounted.positioner(camera).isPresent();
        double shown = turns ? CameraView.lookTime(camera, time) : time;
        RunHistory history =
                turns || Simulation.isSteered(settings) ? simulation().until(shown, () -> false) : new RunHistory();
        if (turns) {
            spec.commandLine().getErr().printf("camera '%s' as it was pointed at %.3f s%n", id, shown);
        }
        DepthImage image = threads.call(
                () -> new CameraView(id, camera, simulation().stage(history, settings), history).draw(shown));
        target.write(ending.equals("png") ? image::writePng : image::writePfm);
        return image.width() + " x " + image.height() + " pixels, " + image.hitCount() + " of them show drones";
    }

    /** A film shows the looks that the camera has in the run, each until the next. */
    @Override
    FilmMaker maker(Film film, RunHistory history) {
        CameraView view = new CameraView(id, camera, simulation().stage(history, settings), history);
        double[] shown = {Double.NaN};
        BufferedImage[] image = new BufferedImage[1];
        return new FilmMaker(film, time -> {
            double look = CameraView.lookTime(camera, time);
            if (look != shown[0]) {
                shown[0] = look;
                image[0] = view.draw(look).toImage();
            }
            return image[0];
        });
    }
}
