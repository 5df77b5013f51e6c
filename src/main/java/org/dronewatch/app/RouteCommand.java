package org.dronewatch.app;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.function.Consumer;
import org.dronewatch.analysis.field.Course;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldGrid;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.analysis.field.LayerStore;
import org.dronewatch.fusion.AreaZone;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.report.route.RouteDirectory;
import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RouteResults;
import org.dronewatch.report.route.RouteScenes;
import org.dronewatch.report.route.RouteTable;
import org.dronewatch.route.RouteArea;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SiteRoutes;
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
                        + " to the middle of the sensors.",
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
            description = "Flies each route N times with different seeds, and compares how often the drone is detected"
                    + " with the probability that follows from all looks of the sensors; 1 to 1,000,000.")
    private Integer proof;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of all random numbers.")
    private Long seed;

    @Option(
            names = "--out",
            paramLabel = "DIR",
            description = "Directory for report.html, route.json, pictures and a scene file of each route.")
    private String out;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @ParentCommand
    private Main main;

    @Spec
    private CommandSpec spec;

    private final Instant started = Instant.now();

    @Override
    public Integer call() {
        threads.number();
        if (proof != null && (proof < 1 || proof > MOST_FLIGHTS)) {
            throw new InputException("--proof " + proof + ": must be 1 to " + MOST_FLIGHTS);
        }
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        runner.notes(spec.commandLine().getErr()::println);
        if (seed != null) {
            runner.seed(seed);
        }
        options.apply(runner);
        SceneSettings settings = runner.settingsOfRuns().get(0);
        String id = drone.of(settings);
        if (settings.enabledSensors().isEmpty()) {
            throw new InputException("the scene has no enabled sensor: no route is weaker than another");
        }
        Optional<AreaZone> launch = options.launchArea(runner, settings);
        try (RouteDirectory target = out == null ? null : new RouteDirectory(PathWord.of("--out", out))) {
            return threads.call(() -> {
                runner.adviseOnConditions();
                Stage stage = runner.stage(settings);
                FieldGrid grid = options.grid(
                        InboundTarget.of(settings, stage.protection()), RouteArea.side(settings, stage, id));
                RouteInputs inputs = new RouteInputs(
                        scene.name(),
                        id,
                        settings,
                        stage.protection(),
                        grid,
                        options.terms().pointing(),
                        options.launch());
                RouteResults results = search(runner, inputs, stage, launch);
                main.interruption().letFinish();
                if (target != null) {
                    target.write(
                            results,
                            inputs,
                            new RouteScenes(inputs, runner::text),
                            stage,
                            new Provenance(
                                    started,
                                    spec.root().commandLine().getParseResult().originalArgs(),
                                    runner.inputs()),
                            threads.number(),
                            spec.commandLine().getErr()::println);
                }
                print(results, inputs);
                return 0;
            });
        }
    }

    private RouteResults search(SceneRunner runner, RouteInputs inputs, Stage stage, Optional<AreaZone> launch) {
        SceneSettings settings = inputs.settings();
        Consumer<String> notes = spec.commandLine().getErr()::println;
        DetectionField field = field(runner, inputs, stage, notes);
        RouteSurvey survey = Progress.during("routes", SiteRoutes.SECTORS + 1, progress -> {
            SiteRoutes routes = routes(field, inputs, stage, launch);
            progress.accept(1);
            return RouteSurvey.of(
                    routes, settings.alert().response(), sector -> progress.accept(1), main.interruption()::letFinish);
        });
        return new RouteFlights(runner, inputs, main.interruption()).of(survey, proof == null ? 0 : proof);
    }

    private DetectionField field(SceneRunner runner, RouteInputs inputs, Stage stage, Consumer<String> notes) {
        SceneSettings settings = inputs.settings();
        List<Course> courses = Course.all(settings.enabledSensors(), DetectionField.droneOf(stage, inputs.drone()));
        FieldRequest request = new FieldRequest(
                settings,
                stage,
                inputs.drone(),
                inputs.grid(),
                courses,
                FieldCoverage.Choice.WORST,
                options.terms(),
                FieldCoverage.DEFAULT_COVERED);
        LayerStore store = LayerStore.of(settings, runner.inputs().models(), LayerStore.standard(notes));
        return Progress.during(
                "detection field", request.looksOfField(), progress -> FieldAssessment.of(request, store, progress));
    }

    private static SiteRoutes routes(DetectionField field, RouteInputs inputs, Stage stage, Optional<AreaZone> launch) {
        try {
            return SiteRoutes.of(field, inputs.settings(), stage, inputs.drone(), launch);
        } catch (IllegalArgumentException e) {
            throw new InputException(e.getMessage(), e);
        }
    }

    private void print(RouteResults results, RouteInputs inputs) {
        RouteTable.lines(results, inputs).forEach(spec.commandLine().getOut()::println);
        if (!results.isComplete()) {
            spec.commandLine()
                    .getErr()
                    .println("interrupted: not all directions were "
                            + (results.survey().isComplete() ? "proved by flights" : "searched"));
        }
    }
}
