package org.dronewatch.app;

import java.awt.image.BufferedImage;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import javax.imageio.ImageIO;
import org.dronewatch.report.WholeFile;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scene.SceneSettings;
import org.dronewatch.scene.Stage;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DepthImage;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.PictureSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Draws what one camera sees at one time, or the site with all that is in it. */
@Command(
        name = "render",
        mixinStandardHelpOptions = true,
        description = {
            "Draws a picture of a scene at one time, without a window: what one camera sees (.png in blues, or .pfm with"
                    + " distances in metres), or the whole site in 3D with its sensors, drones and rays of sound (.png)."
        },
        footer = {
            "",
            "Examples:",
            "  dronewatch render camera-range --camera camera --time 25 --out view.png",
            "  dronewatch render multi-sensor --view orbit --time 12 --out site.png",
            "  dronewatch render closed-space --view top --rays --size 2560x1440 --scale 2 --out rays.png"
        })
final class RenderCommand implements Callable<Integer> {
    @Mixin
    private SceneChoice choice;

    @ArgGroup(multiplicity = "1")
    private Subject subject;

    /** What the picture is of. */
    static final class Subject {
        @Option(names = "--camera", required = true, paramLabel = "ID", description = "Id of the camera in the scene.")
        private String camera;

        @Option(
                names = "--view",
                required = true,
                paramLabel = "top|side|orbit",
                description = "The whole site: a plan, from the side, or in perspective.")
        private SiteView.From view;
    }

    @Mixin
    private SiteView site = new SiteView();

    @Option(
            names = "--time",
            defaultValue = "0",
            paramLabel = "T",
            description = "Time since the start of the run, s; 0 unless given.")
    private String time;

    @Option(names = "--out", required = true, paramLabel = "FILE", description = "File to write: .png or .pfm.")
    private String out;

    @Option(
            names = "--run",
            defaultValue = "0",
            paramLabel = "N",
            description = "Run of a sweep, from 0; 0 unless given.")
    private int run;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        WholeFile target = target();
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        runner.notes(spec.commandLine().getErr()::println);
        SceneSettings settings = settingsOfRun(runner);
        double seconds = seconds(settings);
        if (subject.view != null) {
            drawSite(scene.name(), runner, settings, seconds, target);
        } else {
            drawCamera(runner, settings, seconds, target);
        }
        return 0;
    }

    private void drawCamera(SceneRunner runner, SceneSettings settings, double seconds, WholeFile target) {
        PictureSettings camera = camera(settings);
        DepthImage image = threads.call(() -> {
            Stage stage = runner.stage(settings);
            return new DronePicture(new CameraObject(camera)).depthImage(stage.world(), stage.dronesAt(seconds));
        });
        target.write(isPng() ? image::writePng : image::writePfm);
        spec.commandLine()
                .getOut()
                .printf(
                        "%s: %d x %d pixels, %d of them show drones%n",
                        out, image.width(), image.height(), image.hitCount());
    }

    private void drawSite(String title, SceneRunner runner, SceneSettings settings, double seconds, WholeFile target) {
        if (!isPng()) {
            throw new InputException("--out " + out + ": a picture of the site must end in .png");
        }
        site.check(settings);
        BufferedImage image =
                threads.call(() -> site.draw(title, settings, runner.stage(settings), subject.view, seconds));
        target.write(stream -> ImageIO.write(image, "png", stream));
        spec.commandLine().getOut().printf("%s: %d x %d pixels%n", out, image.getWidth(), image.getHeight());
    }

    private SceneSettings settingsOfRun(SceneRunner runner) {
        List<SceneSettings> runs = runner.settingsOfRuns();
        if (run < 0 || run >= runs.size()) {
            throw new InputException("--run " + run + ": must be 0 to " + (runs.size() - 1));
        }
        return runs.get(run);
    }

    private PictureSettings camera(SceneSettings settings) {
        SensorSettings<?> sensor = settings.sensors().get(subject.camera);
        if (sensor instanceof PictureSettings camera) {
            return camera;
        }
        throw new InputException("--camera " + subject.camera + ": no such camera; the scene's sensors are "
                + String.join(", ", settings.sensors().keySet()));
    }

    private double seconds(SceneSettings settings) {
        double duration = settings.run().duration();
        double seconds;
        try {
            seconds = Quantity.DURATION.parse(time);
        } catch (IllegalArgumentException e) {
            throw new InputException("--time " + time + ": " + e.getMessage(), e);
        }
        if (!(seconds >= 0.0 && seconds <= duration)) {
            throw new InputException("--time " + time + ": must be 0 to " + duration + " s, the scene's duration");
        }
        return seconds;
    }

    private WholeFile target() {
        if (!isPng() && !out.toLowerCase(Locale.ROOT).endsWith(".pfm")) {
            throw new InputException("--out " + out + ": must end in .png or .pfm");
        }
        return new WholeFile("--out", out);
    }

    private boolean isPng() {
        return out.toLowerCase(Locale.ROOT).endsWith(".png");
    }
}
