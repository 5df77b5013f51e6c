package org.dronewatch.app;

import java.io.PrintWriter;
import java.lang.reflect.RecordComponent;
import java.util.Locale;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicLong;
import me.tongfei.progressbar.ProgressBar;
import org.dronewatch.analysis.Coverage;
import org.dronewatch.analysis.CoverageGrid;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.CoveragePicture;
import org.dronewatch.report.CoverageTable;
import org.dronewatch.report.WholeFile;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Draws a plan of what the sensors reach. */
@Command(
        name = "coverage",
        mixinStandardHelpOptions = true,
        description = "Draws a plan of where each sensor detects a drone at one height above the ground, and prints the"
                + " reasons for misses elsewhere.",
        footer = {"", "Example:", "  dronewatch coverage multi-sensor --height 10m --side 400m --out plan.png"})
final class CoverageCommand implements Callable<Integer> {
    @Mixin
    private SceneChoice choice;

    @Option(
            names = "--height",
            defaultValue = "10",
            paramLabel = "H",
            description = "Height above the ground;" + " 10 m by default.")
    private String height;

    @Option(
            names = "--side",
            defaultValue = "500",
            paramLabel = "L",
            description = "Length of a side of the plan, centred on the sensors; 500 m by default.")
    private String side;

    @Option(
            names = "--cells",
            defaultValue = "100",
            paramLabel = "N",
            description = "Points along a side, 2 to 2000; 100 by default.")
    private int cells;

    @Option(names = "--drone", paramLabel = "ID", description = "Drone of the scene; the first by default.")
    private String drone;

    @Option(names = "--out", required = true, paramLabel = "FILE.png", description = "Picture to write.")
    private String out;

    @Mixin
    private ThreadsOption threads = new ThreadsOption();

    @Spec
    private CommandSpec spec;

    @Override
    public Integer call() {
        if (!out.toLowerCase(Locale.ROOT).endsWith(".png")) {
            throw new InputException("--out " + PlainText.value(out) + ": must end in .png");
        }
        threads.number();
        WholeFile target = new WholeFile("--out", out);
        Scene scene = choice.create();
        SceneRunner runner = choice.runner(scene);
        runner.notes(spec.commandLine().getErr()::println);
        SceneSettings settings = runner.settingsOfRuns().get(0);
        CoverageGrid grid = grid(settings);
        String id = drone(settings);
        return threads.call(() -> {
            runner.adviseOnConditions();
            Stage stage = runner.stage(settings);
            Coverage coverage = withProgress(settings, stage, id, grid);
            String words = "drone '" + id + "'";
            CoveragePicture picture = CoveragePicture.of(scene.name(), coverage, stage.world(), words);
            target.write(picture::writePng);
            print(coverage);
            return 0;
        });
    }

    private Coverage withProgress(SceneSettings settings, Stage stage, String id, CoverageGrid grid) {
        long all =
                (long) grid.cells() * grid.cells() * settings.enabledSensors().size();
        ProgressBar bar = Progress.barOf("coverage", all);
        AtomicLong done = new AtomicLong();
        try {
            return Coverage.of(settings, stage, id, grid, points -> {
                long now = done.addAndGet(points);
                if (bar != null) {
                    bar.stepTo(now);
                }
            });
        } finally {
            if (bar != null) {
                bar.close();
            }
        }
    }

    /** The first drone, or the first bird of a scene that has nothing else. */
    private static String first(SceneSettings settings) {
        return settings.individualDrones().keySet().stream()
                .filter(id -> !settings.birds().contains(id))
                .findFirst()
                .orElseGet(() -> settings.birds().iterator().next());
    }

    private String drone(SceneSettings settings) {
        if (settings.individualDrones().isEmpty()) {
            throw new InputException("the scene has no drone to place on the plan");
        }
        String id = drone == null ? first(settings) : drone;
        if (!settings.individualDrones().containsKey(id)) {
            throw new InputException("--drone " + PlainText.value(id) + ": no such drone; the scene has "
                    + String.join(", ", settings.individualDrones().keySet()));
        }
        return id;
    }

    /** About the middle of the sensors. */
    private CoverageGrid grid(SceneSettings settings) {
        if (settings.enabledSensors().isEmpty()) {
            throw new InputException("the scene has no sensors");
        }
        Position sum = new Position(0, 0, 0);
        for (var sensor : settings.enabledSensors().values()) {
            sum = sum.plus(sensor.position());
        }
        Position middle = sum.times(1.0 / settings.enabledSensors().size());
        return new CoverageGrid(
                middle.x(),
                middle.y(),
                (double) value("side", side),
                (int) value("cells", String.valueOf(cells)),
                (double) value("height", height));
    }

    /** The value of an option that has the name of a component of the grid. */
    private static Object value(String name, String text) {
        RecordComponent part = SettingsForm.of(CoverageGrid.class).part(name).orElseThrow();
        try {
            Object value = SettingText.parse(part, text);
            Limits.check(part, value);
            return value;
        } catch (IllegalArgumentException e) {
            throw new InputException("--" + name + " " + PlainText.value(text) + ": " + e.getMessage(), e);
        }
    }

    private void print(Coverage coverage) {
        PrintWriter target = spec.commandLine().getOut();
        CoverageTable.areas(coverage).forEach(target::println);
        target.println();
        CoverageTable.causes(coverage, coverage.causes()).forEach(target::println);
    }
}
