package org.dronewatch.app;

import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.dronewatch.report.WholeFile;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scene.SceneSettings;
import org.dronewatch.scene.Stage;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.DepthImage;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Quantity;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Draws what one camera sees at one time. */
@Command(
        name = "render",
        mixinStandardHelpOptions = true,
        description =
                "Draws what one camera of a scene sees at one time: .png in blues, or .pfm with distances in metres.",
        footer = {"", "Example: dronewatch render camera-range --camera camera --time 25 --out view.png"})
final class RenderCommand implements Callable<Integer> {
    @Mixin
    private SceneChoice choice;

    @Option(names = "--camera", required = true, paramLabel = "ID", description = "Id of the camera in the scene.")
    private String cameraId;

    @Option(names = "--time", required = true, paramLabel = "T", description = "Time since the start of the run, s.")
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
        CameraSettings camera = camera(settings);
        double seconds = seconds(settings);
        DepthImage image = threads.call(() -> {
            Stage stage = runner.stage(settings);
            return camera.create().depthImage(stage.world(), stage.dronesAt(seconds));
        });
        target.write(isPng() ? image::writePng : image::writePfm);
        spec.commandLine()
                .getOut()
                .printf(
                        "%s: %d x %d pixels, %d of them show drones%n",
                        out, image.width(), image.height(), image.hitCount());
        return 0;
    }

    private SceneSettings settingsOfRun(SceneRunner runner) {
        List<SceneSettings> runs = runner.settingsOfRuns();
        if (run < 0 || run >= runs.size()) {
            throw new InputException("--run " + run + ": must be 0 to " + (runs.size() - 1));
        }
        return runs.get(run);
    }

    private CameraSettings camera(SceneSettings settings) {
        SensorSettings<?> sensor = settings.sensors().get(cameraId);
        if (sensor instanceof CameraSettings camera) {
            return camera;
        }
        throw new InputException("--camera " + cameraId + ": no such camera; the scene's sensors are "
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
