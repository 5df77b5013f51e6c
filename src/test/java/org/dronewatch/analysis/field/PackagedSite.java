package org.dronewatch.analysis.field;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.sensor.Encounters;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;

/**
 * A real scene, and the field of one of its drones around its sensors.
 *
 * @param name of the scene
 * @param settings of its first run
 * @param stage its world and drones
 * @param drone the drone, anywhere
 * @param field of that drone
 * @param eyes a sensor by each name, for looks
 */
record PackagedSite(
        String name, SceneSettings settings, Stage stage, Drone drone, DetectionField field, Map<String, Sensor> eyes) {

    /** Sets cells aside from the edges of beams that begin in the middle, where rounding decides, m. */
    private static final double ASIDE = 0.37;

    /** Draws for each cell, before hardly any can be left. */
    private static final int MOST_DRAWS = 100;

    /** A cell in which a drone can be, and a course. */
    record Cell(int height, int column, int row, int course) {}

    /**
     * A scene.
     *
     * @param name of a packaged scene, or a file
     * @param drone in the scene
     * @param side of the area, m
     * @param cell side of a cell, m
     * @param heights above the ground, separated by spaces, m; the default ones if null
     * @param terms on which the drone counts as detected
     * @param sensor the only one that is enabled; all of them are if null
     * @param set a setting and its value, if not null
     */
    static PackagedSite of(
            String name,
            String drone,
            double side,
            double cell,
            String heights,
            FieldTerms terms,
            String sensor,
            String set) {
        Scene scene = name.endsWith(".yaml")
                ? new SceneFile(Path.of(name))
                : PackagedScene.find(name).orElseThrow().factory().get();
        SceneRunner runner = new SceneRunner(scene).notes(note -> {});
        if (set != null) {
            runner.set(set.split("=")[0], set.split("=")[1]);
        }
        for (String id : runner.settingsOfRuns().get(0).enabledSensors().keySet()) {
            if (sensor != null && !id.equals(sensor)) {
                runner.set("sensors." + id + ".enabled", "false");
            }
        }
        SceneSettings settings = runner.settingsOfRuns().get(0);
        Stage stage = runner.stage(settings);
        Position middle = InboundTarget.sensors(settings);
        FieldGrid grid = new FieldGrid(middle.x() + ASIDE, middle.y(), side, cell, levels(heights));
        Drone sample = DetectionField.droneOf(stage, drone);
        List<Course> courses = Course.all(settings.enabledSensors(), sample);
        Map<String, Sensor> eyes = new HashMap<>();
        settings.enabledSensors().forEach((id, one) -> eyes.put(id, one.create()));
        try (Workers workers = new Workers(2)) {
            DetectionField field =
                    workers.call(() -> FieldAssessment.of(settings, stage, drone, grid, courses, terms, cells -> {}));
            return new PackagedSite(name, settings, stage, sample, field, eyes);
        }
    }

    private static List<Double> levels(String text) {
        return text == null
                ? FieldGrid.HEIGHTS
                : Arrays.stream(text.split(" ")).map(Double::valueOf).toList();
    }

    /** Cells at random in which a drone can be, each on a course at random. */
    List<Cell> cells(int count, Random random) {
        List<Cell> cells = new ArrayList<>();
        for (int i = 0; i < MOST_DRAWS * count && cells.size() < count; i++) {
            Cell one = new Cell(
                    random.nextInt(field.grid().heights().size()),
                    random.nextInt(field.grid().columns()),
                    random.nextInt(field.grid().columns()),
                    random.nextInt(field.courses().size()));
            if (field.isOpen(one.height, one.column, one.row)) {
                cells.add(one);
            }
        }
        return cells;
    }

    /** The drone in a cell. */
    Drone at(Cell cell) {
        Position middle = field.middle(cell.height, cell.column, cell.row);
        return drone.at(
                field.courses().get(cell.course).at(middle, drone.settings().speed()));
    }

    /** The settings of a sensor. */
    SensorSettings<?> sensor(String id) {
        return settings.enabledSensors().get(id);
    }

    /** Where the positioner of a sensor points that has turned to a drone. */
    Optional<Pointing> pointing(String id, Drone there) {
        return Mounted.turnedTo(sensor(id), there.origin());
    }

    /** What the first look of a run reports of a drone; empty if nothing. */
    Optional<Observation> look(String id, Drone there) {
        Look look = Look.of(settings.run().seed(), id, 0, 0.0).withPointing(pointing(id, there));
        return eyes.get(id).observe(stage.world(), List.of(there), look).stream()
                .filter(seen -> seen.drone().equals(there.id()))
                .findFirst();
    }

    /**
     * Whether one of several looks of a run detects a drone.
     *
     * @param seed of the run
     * @param looks their number
     */
    boolean isDetected(String id, Drone there, long seed, int looks) {
        double rate = sensor(id).rate();
        Encounters encounters = Encounters.NONE;
        // The drone arrives after the first look: before that, which is when the run begins, no observer has searched.
        for (int number = 1; number <= looks; number++) {
            Look look = Look.of(seed, id, number, number / rate)
                    .withPointing(pointing(id, there))
                    .withEncounters(encounters);
            if (eyes.get(id) instanceof RaySensor rays) {
                if (rays.detects(stage.world(), there, look)) {
                    return true;
                }
                continue;
            }
            List<Observation> seen = eyes.get(id).observe(stage.world(), List.of(there), look);
            if (seen.stream().anyMatch(one -> one.drone().equals(there.id()) && one.isDetected())) {
                return true;
            }
            encounters = Encounters.after(look, rate, seen);
        }
        return false;
    }
}
