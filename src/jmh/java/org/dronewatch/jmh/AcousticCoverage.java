package org.dronewatch.jmh;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.MultiSensor;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Level;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** The field of the microphone of {@code multi-sensor} alone, by the level model, on the default heights. */
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.SECONDS)
@Fork(1)
@Warmup(iterations = 1)
@Measurement(iterations = 3)
@State(Scope.Benchmark)
public class AcousticCoverage {
    /** Length of a cell's side, m; with 0.9 m there are a million cells. */
    @Param({"9.0"})
    public double cell;

    /** Number of threads. */
    @Param({"2"})
    public int threads;

    private SceneSettings settings;
    private Stage stage;

    /** Loads the scene without its cameras. */
    @Setup(Level.Trial)
    public void load() {
        SceneRunner runner = new SceneRunner(new MultiSensor()).notes(note -> {});
        runner.settings().sensors().keySet().stream()
                .filter(id -> !id.equals("microphone"))
                .forEach(id -> runner.set("sensors." + id + ".enabled", "false"));
        settings = runner.settings();
        stage = runner.stage(settings);
    }

    /** The whole field. */
    @Benchmark
    public DetectionField field() {
        FieldGrid grid = new FieldGrid(0.0, 0.0, 400.0, cell, FieldGrid.HEIGHTS);
        List<Course> courses = Course.all(settings.enabledSensors(), DetectionField.droneOf(stage, "quadrotor"));
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> FieldAssessment.of(settings, stage, "quadrotor", grid, courses, cells -> {}));
        }
    }
}
