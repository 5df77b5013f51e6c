package org.dronewatch.app;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.app.console.ExitCode;
import org.dronewatch.app.console.ProgressOptions;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.app.option.DroneOption;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.app.option.RouteOptions;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.app.option.SeedOption;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.app.search.RouteFinder;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.report.route.RouteDirectory;
import org.dronewatch.report.route.RouteFile;
import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RouteResults;
import org.dronewatch.report.route.RouteScenes;
import org.dronewatch.report.route.RouteTable;
import org.dronewatch.route.FlightMode;
import org.dronewatch.route.RouteArea;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/** Finds the routes on which a drone is least exposed. */
@Command(
        name = "route",
        mixinStandardHelpOptions = true,
        description =
                "Finds, from each of eight directions, the route to the protected zone on which the sensors are least likely"
                        + " to detect a drone in time, and writes it as a scene that can be run. Without a zone, routes lead"
                        + " to the centroid of the sensors.",
        footer = {
            "",
            "Examples:",
            "  dronewatch route scenes/palace.yaml --out weakest",
            "  dronewatch route multi-sensor --side 600m --cell 10m --heights 5m,10m,20m,40m,80m",
            "  dronewatch route scenes/palace.yaml --response 30s --launch '{centre: [900, -900], radius: 100 m}'"
        })
final class RouteCommand implements Callable<Integer> {
    private static final int MOST_FLIGHTS = 1_000_000;

    @Mixin
    private SceneChoice choice;

    @Mixin
    private DroneOption drone = new DroneOption();

    @Mixin
    private RouteOptions options = new RouteOptions();

    @Option(
            names = "--proof",
            paramLabel = "N",
            description = "Flies each route N times with different seeds, and compares the proportion of flights in"
                    + " which the drone is detected with the probability computed from all looks of the sensors;"
                    + " 1 to 1,000,000.")
    private Integer proof;

    @Mixin
    private SeedOption seed = new SeedOption();

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Directory for report.html, route.json, pictures and a scene file of each route.")
    private String out;

    @Option(
            names = "--view",
            description = "Also opens a window in which a drone flies each of the routes, all at the same time.")
    private boolean view;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @Mixin
    private ProgressOptions display = new ProgressOptions();

    @Mixin
    private JsonOption json = new JsonOption();

    @ParentCommand
    private Main main;

    @Spec
    private CommandSpec spec;

    private final Instant started = Instant.now();

    @Override
    public Integer call() {
        threads.number();
        int flights = flights();
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        TaskProgress shown = display.on(spec.commandLine().getErr());
        runner.notes(shown.notes());
        seed.apply(runner);
        options.apply(runner);
        SceneSettings settings = runner.settingsOfRuns().get(0);
        String id = drone.of(settings);
        if (settings.enabledSensors().isEmpty()) {
            throw new InputException("the scene has no enabled sensor: no route is weaker than another");
        }
        options.stopped(settings);
        List<FlightMode> modes = options.modes(
                settings.individualDrones().get(id), settings.enabledSensors().values());
        Optional<AreaZone> launch = options.launchArea(runner, settings);
        RouteWindow window = new RouteWindow(
                scene,
                runner,
                new SceneWindow(threads.number(), spec.commandLine().getErr(), shown.notes()));
        if (view && !window.canOpen()) {
            return ExitCode.NO_DISPLAY;
        }
        Runnable watch;
        try (RouteDirectory target = out == null ? null : new RouteDirectory(PathWord.of("--out", out), scene)) {
            watch = threads.call(() -> {
                runner.adviseOnConditions();
                Stage stage = runner.stage(settings);
                RouteInputs inputs = inputs(scene.name(), id, settings, stage);
                RouteResults results =
                        new RouteFinder(runner, inputs, stage, main.interruption(), shown).find(modes, launch, flights);
                main.interruption().letFinish();
                RouteScenes scenes = new RouteScenes(inputs, runner::text);
                if (target != null) {
                    target.write(
                            results,
                            inputs,
                            scenes,
                            stage,
                            runner.load(settings),
                            new Provenance(
                                    started,
                                    spec.root().commandLine().getParseResult().originalArgs(),
                                    runner.inputs()),
                            threads.number(),
                            shown.notes());
                }
                print(results, inputs);
                return () -> window.show(results.survey(), scenes);
            });
        }
        if (view) {
            watch.run();
        }
        return 0;
    }

    /** The number of seeds with which each route is flown; 0 for none. */
    private int flights() {
        if (proof != null && (proof < 1 || proof > MOST_FLIGHTS)) {
            throw new InputException("--proof " + proof + ": must be 1 to " + MOST_FLIGHTS);
        }
        return proof == null ? 0 : proof;
    }

    private RouteInputs inputs(String scene, String id, SceneSettings settings, Stage stage) {
        FieldGrid grid = options.grid(
                InboundTarget.of(settings, stage.protection()),
                RouteArea.side(settings, stage, id),
                settings.individualDrones().get(id).flightLimits().ceiling());
        return new RouteInputs(
                scene,
                id,
                settings,
                stage.protection(),
                grid,
                options.pointing(),
                options.launch(),
                options.stopped(settings));
    }

    private void print(RouteResults results, RouteInputs inputs) {
        json.print(() -> RouteFile.toJson(results, inputs), target -> RouteTable.lines(results, inputs)
                .forEach(target::println));
        if (!results.isComplete()) {
            spec.commandLine()
                    .getErr()
                    .println("interrupted: "
                            + (results.survey().isComplete()
                                    ? "there are routes from all directions, but not all searches and flights are complete"
                                    : "not all directions were searched"));
        }
    }
}
