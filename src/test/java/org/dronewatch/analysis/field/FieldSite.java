package org.dronewatch.analysis.field;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Cause;

/**
 * A plain with four boxes, one of each role, and a sensor of each kind: whatever the tests expect there, they compute
 * from these boxes.
 *
 * @param settings of the scene
 * @param stage its world and drones
 */
public record FieldSite(SceneSettings settings, Stage stage) {
    /** The drone. */
    public static final String DRONE = "one";

    /** A box that is aligned with the axes, from the ground up. */
    record Box(double west, double south, double east, double north, double height) {
        boolean contains(double x, double y) {
            return x > west && x < east && y > south && y < north;
        }

        /** Whether a segment passes through it: by the slabs between its faces. */
        boolean blocks(Position from, Position to) {
            double[] low = {west, south, -1.0};
            double[] high = {east, north, height};
            double[] start = {from.x(), from.y(), from.z()};
            double[] end = {to.x(), to.y(), to.z()};
            double enters = 0.0;
            double leaves = 1.0;
            for (int axis = 0; axis < 3; axis++) {
                double along = end[axis] - start[axis];
                double first = (low[axis] - start[axis]) / along;
                double second = (high[axis] - start[axis]) / along;
                enters = Math.max(enters, Math.min(first, second));
                leaves = Math.min(leaves, Math.max(first, second));
            }
            return enters < leaves;
        }

        /** With the y axis up, as in the files of most programs, and faces outward. */
        private String obj() {
            StringBuilder text = new StringBuilder();
            for (int corner = 0; corner < 8; corner++) {
                text.append(String.format(
                        Locale.ROOT,
                        "v %s %s %s%n",
                        (corner & 1) == 0 ? west : east,
                        (corner & 2) == 0 ? 0.0 : height,
                        (corner & 4) == 0 ? -north : -south));
            }
            return text + "f 1 3 4 2\nf 5 6 8 7\nf 1 5 7 3\nf 2 4 8 6\nf 1 2 6 5\nf 3 7 8 4\n";
        }
    }

    static final Map<String, Box> BOXES = Map.of(
            "building", new Box(-20, 60, 20, 70, 30),
            "vegetation", new Box(80, -15, 90, 25, 25),
            "other", new Box(-25, -80, 30, -70, 20),
            "terrain", new Box(-110, -30, -60, 10, 15));

    private static final String WORLD =
            """
            world:
              backgroundNoise: 20
              models:
                - {file: plain.obj, role: terrain}
                - {file: terrain.obj, role: terrain}
                - {file: building.obj, role: building}
                - {file: vegetation.obj, role: vegetation}
                - {file: other.obj, role: other}
            drones:
              one:
                model: packaged:quadrotor.obj
                speed: 12 m/s
                soundLevel: 38
                radio: {power: -10, frequency: 2.4e9}
                flight: {kind: hover, position: [0, 300, 40]}
            """;

    /** Detects within 150 m whatever is not hidden entirely, if it approaches or recedes at 3 m/s. */
    public static final String ROUND =
            """
              round: {kind: radar, position: [0, 0, 4], minRange: 1, maxRange: 150, elevationWidth: 90 deg, minSpeed: 3 m/s,
                budget: {range: 5000, crossSection: 0.01}}
            """;

    /** Sensors of all kinds that are assessable, one of them on a positioner. */
    public static final String ALL = ROUND
            + """
              notched: {kind: radar, position: [5, 0, 4], minRange: 1, maxRange: 400, elevationWidth: 90 deg, azimuthWidth: 120 deg,
                budget: {range: 160, crossSection: 0.01}, notch: {kind: high-pass, halfPowerSpeed: 4 m/s},
                detection: {kind: chance, pulses: 8}}
              radio: {kind: rf, position: [0, 5, 4], threshold: 12}
              eye: {kind: camera, position: [0, 0, 4], fov: 40 deg, width: 800, height: 600}
              heat: {kind: thermal, position: [0, 0, 4], fov: 8 deg, aim: {azimuth: 90 deg, elevation: 5 deg}}
              turning: {kind: camera, position: [3, 0, 4], fov: 6 deg, width: 640, height: 480, positioner: {cues: [round]}}
              ear: {kind: acoustic, position: [0, 0, 4], propagation: {kind: level-model, initialRays: 4, reflectionsPerHit: 1, maxOrder: 1}}
            """;

    /** The site with sensors given as lines of a scene file, which is {@code site.yaml} in the directory. */
    public static FieldSite in(Path directory, String sensors) throws IOException {
        Files.writeString(
                directory.resolve("plain.obj"),
                "v -500 0 -500\nv 500 0 -500\nv 500 0 500\nv -500 0 500\nf 1 4 3\nf 1 3 2\n");
        for (Map.Entry<String, Box> box : BOXES.entrySet()) {
            Files.writeString(
                    directory.resolve(box.getKey() + ".obj"), box.getValue().obj());
        }
        Path file = directory.resolve("site.yaml");
        Files.writeString(file, WORLD + "sensors:\n" + sensors + "run: {duration: 1 s, seed: 7}\n");
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        return new FieldSite(runner.settings(), runner.stage(runner.settings()));
    }

    /** The field on all courses. */
    public DetectionField field(FieldGrid grid, int threads) {
        return field(grid, FieldTerms.ONE_LOOK, threads);
    }

    /** The same on other terms. */
    public DetectionField field(FieldGrid grid, FieldTerms terms, int threads) {
        List<Course> courses = Course.all(settings.enabledSensors(), DetectionField.droneOf(stage, DRONE));
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> FieldAssessment.of(settings, stage, DRONE, grid, courses, terms, cells -> {}));
        }
    }

    /** The cause of the first box between two points. */
    public static Optional<Cause> hidden(Position from, Position to) {
        // The boxes lie in different directions from the middle: no line from there meets two of them.
        return BOXES.entrySet().stream()
                .filter(box -> box.getValue().blocks(from, to))
                .map(box -> Cause.valueOf("HIDDEN_BY_" + box.getKey().toUpperCase(Locale.ROOT)))
                .findFirst();
    }
}
