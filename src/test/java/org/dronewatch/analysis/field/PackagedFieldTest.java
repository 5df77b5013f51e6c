package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assumptions.assumeThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Fields of real scenes against looks at random cells: where a probability is stored as 0 or 1, a look gives the same
 * answer, also where levels of sound are interpolated (the last field). With {@code -Ddronewatch.field=run} all fields
 * and 2,000 cells of each, otherwise the fastest and fewer.
 */
class PackagedFieldTest {
    private static final boolean ALL = "run".equals(System.getProperty("dronewatch.field"));
    private static final int CELLS = ALL ? 2000 : 200;

    @ParameterizedTest
    @CsvSource({
        "scenes/hill-radar.yaml, quadrotor, 1000, 40,",
        "multi-sensor, quadrotor, 400, 8,",
        "scenes/monaco.yaml, from-the-sea, 3600, 120, microphone=false",
        "scenes/monaco.yaml, from-the-sea, 500, 5, radar-sea=false radar-mountain=false radio=false camera=false thermal=false"
    })
    void whereAFieldIsCertainALookAgrees(String name, String drone, double side, double cell, String enabled) {
        assumeThat(ALL || name.endsWith("hill-radar.yaml")).isTrue();
        Scene scene = name.endsWith(".yaml")
                ? new SceneFile(Path.of(name))
                : PackagedScene.find(name).orElseThrow().factory().get();
        SceneRunner runner = new SceneRunner(scene).notes(note -> {});
        for (String one : enabled == null ? new String[0] : enabled.split(" ")) {
            runner.set("sensors." + one.split("=")[0] + ".enabled", one.split("=")[1]);
        }
        SceneSettings settings = runner.settingsOfRuns().get(0);
        Stage stage = runner.stage(settings);
        Position middle = InboundTarget.sensors(settings);
        FieldGrid grid = new FieldGrid(middle.x(), middle.y(), side, cell, FieldGrid.HEIGHTS);
        Drone sample = DetectionField.droneOf(stage, drone);
        List<Course> courses = Course.all(settings.enabledSensors(), sample);
        DetectionField field;
        try (Workers workers = new Workers(2)) {
            field = workers.call(() -> DetectionField.of(settings, stage, drone, grid, courses, cells -> {}));
        }
        long seed = System.nanoTime();
        System.out.println("PackagedFieldTest: seed " + seed);
        Random random = new Random(seed);
        int certain = 0;
        for (int i = 0; i < CELLS; i++) {
            int height = random.nextInt(grid.heights().size());
            int column = random.nextInt(grid.columns());
            int row = random.nextInt(grid.columns());
            int course = random.nextInt(courses.size());
            if (field.isOpen(height, column, row)) {
                Drone there = sample.at(courses.get(course)
                        .at(field.middle(height, column, row), sample.settings().speed()));
                for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
                    double stored = field.probability(sensor, height, column, row, course);
                    boolean isKnown = field.cause(sensor, height, column, row, course) != Cause.UNKNOWN;
                    if (isKnown && (stored == 0.0 || stored == 1.0)) {
                        certain++;
                        assertThat(look(settings, stage, field.sensors().get(sensor), there))
                                .as(
                                        "seed %d, %s of %s at %s",
                                        seed, field.sensors().get(sensor), name, there.origin())
                                .isEqualTo(stored == 1.0);
                    }
                }
            }
        }
        assertThat(certain).isGreaterThan(CELLS / 2);
    }

    /** Whether a sensor that points at a drone detects it; for an observer, whether he is able to, given time. */
    private static boolean look(SceneSettings settings, Stage stage, String id, Drone drone) {
        Map<String, SensorSettings<?>> sensors = settings.enabledSensors();
        SensorSettings<?> sensor = sensors.get(id);
        Look look = Look.of(settings.run().seed(), id, 0, 0.0).withPointing(Mounted.turnedTo(sensor, drone.origin()));
        return sensor.create().observe(stage.world(), List.of(drone), look).stream()
                .anyMatch(seen -> isDetected(sensor, seen));
    }

    private static boolean isDetected(SensorSettings<?> sensor, Observation seen) {
        return sensor.chance() == Chance.PER_ENCOUNTER ? seen.probability() == 1.0 : seen.isDetected();
    }
}
