package org.dronewatch.app;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.Callable;
import org.dronewatch.app.console.Notes;
import org.dronewatch.app.option.ColourOptions;
import org.dronewatch.app.option.RunTime;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.app.rendering.CameraRendering;
import org.dronewatch.app.rendering.FilmOptions;
import org.dronewatch.app.rendering.Rendering;
import org.dronewatch.app.rendering.Simulation;
import org.dronewatch.app.rendering.SiteRendering;
import org.dronewatch.app.rendering.SiteView;
import org.dronewatch.render.CameraView;
import org.dronewatch.render.film.FilmFormat;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine.ArgGroup;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** Draws what one camera sees, or the site with all that is in it: at one time, or as a film. */
@Command(
        name = "render",
        mixinStandardHelpOptions = true,
        description = {
            "Draws a picture of a scene at a given time, without a window: from one camera (PNG in shades of"
                    + " blue or in colour, or PFM with distances in metres), or of the whole site in 3D with its"
                    + " sensors, drones and sound rays (PNG); or makes a video of either (MP4, or GIF for pages that show"
                    + " pictures but no videos).",
            "For a video, and for a camera on a positioner, the run is simulated."
        },
        footer = {
            "",
            "Examples:",
            "  dronewatch render camera-range --camera camera --time 25 --out view.png",
            "  dronewatch render closed-space --camera camera --colour --out church.png",
            "  dronewatch render multi-sensor --view orbit --time 12 --out site.png",
            "  dronewatch render closed-space --view top --rays --scale 2 --out rays.png",
            "  dronewatch render multi-sensor --view orbit --speed 4 --out site.mp4"
        })
final class RenderCommand implements Callable<Integer> {
    @Mixin
    private SceneChoice choice;

    @ArgGroup(multiplicity = "1")
    private Subject subject;

    /** What the picture is of. */
    static final class Subject {
        @Option(names = "--camera", required = true, paramLabel = "ID", description = "ID of the camera in the scene.")
        private String camera;

        @Option(
                names = "--view",
                required = true,
                paramLabel = "top|side|orbit",
                description = "The whole site: as a plan, from the side, or in perspective.")
        private SiteView.From view;
    }

    @Mixin
    private ColourOptions colours = new ColourOptions();

    @Mixin
    private SiteView site = new SiteView();

    @Option(
            names = "--time",
            paramLabel = "T",
            description = "Time of a picture since the start of the run, s; 0 by default.")
    private String time;

    @Mixin
    private FilmOptions films = new FilmOptions();

    @Option(
            names = "--seed",
            paramLabel = "N",
            description = "Seed of all random numbers, on which the pointing of a positioner may depend.")
    private Long seed;

    @Option(
            names = "--out",
            required = true,
            paramLabel = "FILE",
            description = "File to write: .png, .pfm, .mp4 or .gif.")
    private String out;

    @Option(
            names = "--run",
            defaultValue = "0",
            paramLabel = "N",
            description = "Index of the run in a sweep, counted from 0; 0 by default.")
    private int run;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @ParentCommand
    private Main main;

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        WholeFile target = target();
        OptionalInt samples = colours.samples(subject.view == null, ending());
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene).threads(threads.number());
        if (seed != null) {
            runner.seed(seed);
        }
        runner.notes(Notes.of(spec));
        SceneSettings settings = SceneChoice.settingsOfRun(runner, run);
        Simulation simulation = new Simulation(scene, runner, run, threads.number(), !Notes.areOff(spec));
        Rendering rendering = subject.view != null
                ? new SiteRendering(scene.name(), settings, simulation, site, subject.view)
                : new CameraRendering(settings, simulation, camera(settings), samples);
        rendering.check(ending());
        Optional<FilmFormat> format = FilmFormat.ofEnding(ending());
        String said = format.isPresent()
                ? rendering.film(
                        films.film(settings.run().duration()),
                        target,
                        format.get(),
                        threads,
                        main.interruption()::happened)
                : rendering.picture(seconds(settings), ending(), target, threads, spec);
        spec.commandLine().getOut().println(out + ": " + said);
        return 0;
    }

    private String camera(SceneSettings settings) {
        List<String> cameras = CameraView.cameras(settings.sensors());
        if (cameras.contains(subject.camera)) {
            return subject.camera;
        }
        throw new InputException("--camera " + PlainText.value(subject.camera) + ": "
                + (settings.sensors().containsKey(subject.camera)
                        ? "takes no pictures ("
                                + settings.sensors().get(subject.camera).kind() + ")"
                        : "no such camera")
                + (cameras.isEmpty()
                        ? "; the scene has no camera"
                        : "; cameras in the scene: " + String.join(", ", cameras)));
    }

    private double seconds(SceneSettings settings) {
        return time == null ? 0.0 : RunTime.parse("--time", time, settings.run().duration());
    }

    private WholeFile target() {
        boolean isFilm = FilmFormat.ofEnding(ending()).isPresent();
        if (!isFilm && !List.of("png", "pfm").contains(ending())) {
            throw new InputException("--out " + PlainText.value(out) + ": must end in .png, .pfm, .mp4 or .gif");
        }
        if (!isFilm) {
            films.checkUnused();
        } else if (time != null) {
            throw new InputException("--time " + PlainText.value(time) + ": a video takes --from and --to");
        }
        return new WholeFile("--out", out);
    }

    private String ending() {
        int dot = out.lastIndexOf('.');
        return dot < 0 ? "" : out.substring(dot + 1).toLowerCase(Locale.ROOT);
    }
}
