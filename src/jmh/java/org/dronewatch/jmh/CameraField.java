package org.dronewatch.jmh;

import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.drone.Drone;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.MultiSensor;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Time of a field of coverage: a quadrotor in front of the twelve cameras of {@code multi-sensor}, on nine courses. */
@State(Scope.Benchmark)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.MILLISECONDS)
@Fork(1)
@Warmup(iterations = 2, time = 5)
@Measurement(iterations = 3, time = 10)
public class CameraField {
    /** Cells along a side of 500 m, at each of five heights: 447 make a million cell-heights. */
    @Param({"100", "447"})
    public int cells;

    /** Number of threads. */
    @Param({"2"})
    public int threads;

    private SceneSettings settings;
    private Stage stage;
    private Drone drone;
    private List<Course> courses;
    private FieldGrid grid;

    /** Loads the scene. */
    @Setup
    public void load() {
        SceneRunner runner =
                new SceneRunner(new MultiSensor()).notes(note -> {}).set("sensors.microphone.enabled", "false");
        settings = runner.settingsOfRuns().get(0);
        stage = runner.stage(settings);
        drone = stage.dronesAt(0.0).get(0);
        courses = Course.all(settings.enabledSensors(), drone);
        grid = new FieldGrid(0, 0, 500, 500.0 / cells, FieldGrid.HEIGHTS);
    }

    /** All sensors in all cells, with silhouettes that the first call has made. */
    @Benchmark
    public DetectionField field() {
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> FieldAssessment.of(settings, stage, drone.id(), grid, courses, done -> {}));
        }
    }
}
