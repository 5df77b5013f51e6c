package org.dronewatch.app;

import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.dronewatch.analysis.Coverage;
import org.dronewatch.analysis.CoverageGrid;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.field.InboundTarget;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.analysis.survey.FieldCondition;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.app.console.ProgressOptions;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.app.option.DroneOption;
import org.dronewatch.app.option.FieldOptions;
import org.dronewatch.app.option.GridOptions;
import org.dronewatch.app.option.JsonOption;
import org.dronewatch.app.option.PathWord;
import org.dronewatch.app.option.SceneChoice;
import org.dronewatch.app.option.SeedOption;
import org.dronewatch.app.option.ThreadsOption;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.coverage.CoverageDirectory;
import org.dronewatch.report.coverage.FieldFile;
import org.dronewatch.report.coverage.PlanJson;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.coverage.table.CoverageSite;
import org.dronewatch.report.coverage.table.CoverageTable;
import org.dronewatch.report.coverage.table.SurveyTables;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.report.provenance.Provenance;
import org.dronewatch.report.sheet.CoveragePicture;
import org.dronewatch.run.Stage;
import org.dronewatch.run.store.SiteStore;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.ConditionedScene;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParentCommand;
import picocli.CommandLine.Spec;

/**
 * Finds where the sensors detect a drone, and why they do not elsewhere; or draws a plan of the coverage at one height.
 */
@Command(
        name = "coverage",
        mixinStandardHelpOptions = true,
        description =
                "Prints where the sensors detect a drone at several heights above the ground, the reasons for misses"
                        + " elsewhere, the largest gaps, and what each sensor adds. With --out FILE.png, draws a plan"
                        + " instead, which shows where each sensor detects the drone at one height.",
        footer = {
            "",
            "Examples:",
            "  dronewatch coverage multi-sensor --heights 10m,30m --side 400m --out field",
            "  dronewatch coverage scenes/hill-radar.yaml --within 5s --covered 0.9",
            "  dronewatch coverage scenes/cued-camera.yaml --pointing search --within 30s",
            "  dronewatch coverage scenes/monaco.yaml --area stadium --out field",
            "  dronewatch coverage multi-sensor --height 10m --side 400m --out plan.png"
        })
final class CoverageCommand implements Callable<Integer> {
    private static final double DEFAULT_HEIGHT = 10.0;

    @Mixin
    private SceneChoice choice;

    @Option(
            names = "--height",
            paramLabel = "H",
            description = "Height of a plan above the surface (ground or roof) at each point; 10 m by default.")
    private String height;

    @Option(
            names = "--side",
            paramLabel = "L",
            description = "Length of a side of the area, centred on the sensors; 500 m by default.")
    private String side;

    @Option(
            names = "--cells",
            paramLabel = "N",
            description =
                    "Cells along each side of a plan (--out FILE.png), 2 to 2000; 100 by default. For tables and reports,"
                            + " use --cell.")
    private Integer cells;

    @Mixin
    private DroneOption drone = new DroneOption();

    @Option(
            names = "--out",
            paramLabel = "DIR|PICTURE",
            description = "Directory for report.html, coverage.json and maps, or the picture file of a plan.")
    private String out;

    @Mixin
    private FieldOptions field = new FieldOptions();

    @Mixin
    private SeedOption seed = new SeedOption();

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
        boolean isPlan = out != null && out.toLowerCase(Locale.ROOT).endsWith(".png");
        checkForm(isPlan);
        threads.number();
        TaskProgress shown = display.on(spec.commandLine().getErr());
        return isPlan ? drawPlan(shown) : assessField(shown);
    }

    /** The options of the two forms are mutually exclusive. */
    private void checkForm(boolean isPlan) {
        if (isPlan && field.given() != null) {
            throw new InputException(field.given() + ": has no effect on a plan: name a directory with --out, not "
                    + PlainText.value(out));
        }
        String ofPlan = height != null ? "--height" : cells != null ? "--cells" : null;
        if (!isPlan && ofPlan != null) {
            throw new InputException(
                    ofPlan + ": applies only to a plan, which needs --out FILE.png; for several heights use"
                            + " --heights and --cell");
        }
    }

    private int drawPlan(TaskProgress shown) {
        WholeFile target = new WholeFile("--out", out);
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        runner.notes(shown.notes());
        seed.apply(runner);
        SceneSettings settings = runner.settingsOfRuns().get(0);
        CoverageGrid grid = planGrid(settings);
        String id = drone.of(settings);
        return threads.call(() -> {
            runner.adviseOnConditions();
            Stage stage = runner.stage(settings);
            Coverage coverage = shown.during(
                    "coverage",
                    (long) grid.cells()
                            * grid.cells()
                            * settings.enabledSensors().size(),
                    progress -> Coverage.of(settings, stage, id, grid, progress));
            String words = "drone '" + id + "'";
            CoveragePicture picture = CoveragePicture.of(scene.name(), coverage, stage.world(), words, stage.credits());
            target.write(picture::writePng);
            print(coverage, scene.name(), id);
            return 0;
        });
    }

    private int assessField(TaskProgress shown) {
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        runner.notes(shown.notes());
        seed.apply(runner);
        SceneSettings settings = runner.settingsOfRuns().get(0);
        FieldGrid grid = field.grid(
                settings, side == null ? OptionalDouble.empty() : OptionalDouble.of((double) value("side", side)));
        GridOptions.wholeCells(grid).ifPresent(shown.notes());
        String id = drone.of(settings);
        List<ConditionedScene> others =
                ConditionedScene.of(field.conditions(), () -> choice.runner(choice.create()), id);
        CoverageInputs inputs = new CoverageInputs(
                scene.name(),
                id,
                field.heading(),
                field.covered(),
                field.terms(),
                field.area(),
                settings.world().origin());
        try (CoverageDirectory target = out == null ? null : new CoverageDirectory(PathWord.of("--out", out))) {
            return threads.call(() -> {
                runner.adviseOnConditions();
                Stage site = runner.stage(settings);
                FieldRequest request =
                        request(settings, site, id, grid, field.kind().courses(settings, site, id, grid));
                List<FieldCondition> conditions = others.stream()
                        .map(one -> new FieldCondition(one.name(), () -> under(one, request, runner)))
                        .toList();
                long looks = request.looks() + conditions.size() * request.looksOfField();
                SiteStore kept = LayerStore.standard(runner.store(), shown.notes());
                Function<SceneSettings, LayerStore> stores =
                        one -> LayerStore.of(one, runner.inputs().models(), kept);
                FieldSurvey survey = shown.during(
                        "coverage",
                        looks,
                        progress ->
                                FieldSurvey.of(request, conditions, stores, progress, main.interruption()::letFinish));
                if (target != null) {
                    if (inputs.origin().isEmpty()) {
                        shown.notes()
                                .accept("the scene has no world.origin: no GeoTIFF, GeoJSON or KML files are written");
                    }
                    target.write(
                            survey, inputs, new CoverageSite(settings, request.stage()), provenance(runner, settings));
                }
                print(survey, inputs);
                return 0;
            });
        }
    }

    private FieldRequest request(SceneSettings settings, Stage stage, String id, FieldGrid grid, List<Course> courses) {
        return new FieldRequest(settings, stage, id, grid, courses, field.choice(), field.terms(), field.covered());
    }

    /** The request for the same cells under a condition. */
    private FieldRequest under(ConditionedScene condition, FieldRequest asItIs, SceneRunner runner) {
        try {
            Stage stage = runner.stage(condition.settings());
            List<Course> courses = field.kind().coursesUnder(asItIs, condition.settings(), stage);
            return request(condition.settings(), stage, asItIs.drone(), asItIs.grid(), courses);
        } catch (InputException e) {
            throw new InputException("condition " + PlainText.value(condition.name()) + ": " + e.getMessage(), e);
        }
    }

    private Map<String, String> provenance(SceneRunner runner, SceneSettings settings) {
        List<String> command = spec.root().commandLine().getParseResult().originalArgs();
        return new Provenance(started, command, runner.inputs())
                .inWords(settings.run().seed(), threads.number());
    }

    /** The grid of a plan, centred on the sensors. */
    private CoverageGrid planGrid(SceneSettings settings) {
        Position middle = InboundTarget.sensors(settings);
        return new CoverageGrid(
                middle.x(),
                middle.y(),
                side == null ? FieldGrid.DEFAULT_SIDE : (double) value("side", side),
                cells == null ? (int) FieldGrid.DEFAULT_CELLS : (int) value("cells", String.valueOf(cells)),
                height == null ? DEFAULT_HEIGHT : (double) value("height", height));
    }

    /** The value of an option that has the name of a component of the grid. */
    private static Object value(String name, String text) {
        return FieldOptions.value(name, text, CoverageGrid.class, name);
    }

    private void print(Coverage coverage, String scene, String id) {
        json.print(() -> PlanJson.of(coverage, scene, id), target -> {
            CoverageTable.areas(coverage).forEach(target::println);
            target.println();
            CoverageTable.causes(coverage, coverage.causes()).forEach(target::println);
        });
    }

    /** Where to find the tables that are too long to be printed. */
    private String report() {
        return out == null
                ? "--out DIR writes all of them to report.html"
                : "see " + PlainText.value(Path.of(out).resolve("report.html").toString());
    }

    private void print(FieldSurvey survey, CoverageInputs inputs) {
        json.print(() -> FieldFile.toJson(survey, inputs), target -> SurveyTables.lines(survey, inputs, report())
                .forEach(target::println));
        if (!survey.isComplete()) {
            spec.commandLine().getErr().println("interrupted: " + SurveyTables.missing(survey));
        }
    }
}
