package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.drone.Drone;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.FlightMode;
import org.dronewatch.route.ModeField;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Two parallel walls, 4 m apart and 20 m high, across a plain, with a radar on either side: neither sees what is
 * between the walls, but cells of 15 m have their middles outside.
 */
class UnseenPlacesTest {
    private static final double GAP = 4.0;
    private static final double TOP = 20.0;
    private static final double LOWEST = 6.0;
    private static final double MIDDLE = 15.0;
    private static final double HIGHEST = 30.0;

    private static final String SCENE =
            """
            world:
              models:
                - {file: plain.obj, upAxis: z, role: terrain}
                - {file: walls.obj, upAxis: z}
            drones:
              one: {model: packaged:quadrotor.obj, speed: 10 m/s, flight: {kind: hover, position: [0, 0, 30]}}
            sensors:
              north: {kind: radar, position: [0, 200, 12], elevationWidth: 120 deg, minSpeed: SLOWEST, minRange: 1, rate: 4,
                budget: {range: 400, crossSection: 0.01}, detection: {kind: chance}}
              south: {kind: radar, position: [0, -200, 12], elevationWidth: 120 deg, minSpeed: SLOWEST, minRange: 1, rate: 4,
                budget: {range: 400, crossSection: 0.01}, detection: {kind: chance}}
            run: {duration: 1 s}
            """;

    @TempDir
    private Path directory;

    /** A box of a model file, 1 m thick, with faces outward. */
    private static String wall(double south, int first) {
        StringBuilder text = new StringBuilder();
        for (int corner = 0; corner < 8; corner++) {
            text.append("v %s %s %s\n"
                    .formatted(
                            (corner & 1) == 0 ? -200 : 200,
                            (corner & 2) == 0 ? south : south + 1,
                            (corner & 4) == 0 ? -1 : TOP));
        }
        for (int[] face :
                new int[][] {{1, 3, 4, 2}, {5, 6, 8, 7}, {1, 2, 6, 5}, {3, 7, 8, 4}, {1, 5, 7, 3}, {2, 4, 8, 6}}) {
            text.append("f");
            for (int corner : face) {
                text.append(' ').append(first + corner - 1);
            }
            text.append('\n');
        }
        return text.toString();
    }

    private UnseenPlaces places(double cell, String slowest, int threads) throws IOException {
        return places(SCENE.replace("SLOWEST", slowest), cell, threads, List.of(FlightMode.Kind.POWERED));
    }

    private UnseenPlaces places(String scene, double cell, int threads, List<FlightMode.Kind> kinds)
            throws IOException {
        Files.writeString(
                directory.resolve("plain.obj"), "v -300 -300 0\nv 300 -300 0\nv 300 300 0\nv -300 300 0\nf 1 2 3 4\n");
        Files.writeString(directory.resolve("walls.obj"), wall(0.5 * GAP, 1) + wall(-0.5 * GAP - 1, 9));
        Path file = directory.resolve("scene.yaml");
        Files.writeString(file, scene);
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        SceneSettings settings = runner.settings();
        Stage stage = runner.stage(settings);
        Drone drone = DetectionField.droneOf(stage, "one");
        FieldGrid grid = new FieldGrid(0, 0, 300, cell, List.of(LOWEST, MIDDLE, HIGHEST));
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> {
                List<ModeField> fields = new ArrayList<>();
                for (FlightMode mode : FlightMode.of(
                        drone.settings(), settings.enabledSensors().values())) {
                    if (!kinds.contains(mode.kind())) {
                        continue;
                    }
                    List<Course> courses = mode.courses(settings.enabledSensors(), drone);
                    DetectionField field = FieldAssessment.of(settings, stage, "one", grid, courses, cells -> {});
                    fields.add(mode.with(field, drone.settings()));
                }
                return UnseenPlaces.of(fields, settings);
            });
        }
    }

    /** The square root of the share of levels is spread evenly over the places: 20 m are 4/3 of two steps of height. */
    @Test
    void aPassageBetweenTheMiddlesOfCellsIsNoticed() throws IOException {
        UnseenPlaces places = places(15.0, "0 m/s", 2);
        double levels = (1.0 + (TOP - MIDDLE) / (HIGHEST - MIDDLE)) / 2.0;
        double passage = GAP / (300.0 - 15.0) * Math.sqrt(levels);

        assertThat(places.tried()).isBetween(4000, 4096);
        assertThat(places.unseen()).isCloseTo((int) Math.rint(passage * 4096), within(4));
        assertThat(places(15.0, "0 m/s", 1)).isEqualTo(places);
    }

    /** In the passage, a microphone hears running motors, but no radar detects the drone once they are off. */
    @Test
    void aPassageThatIsOpenToAGliderIsNoticed() throws IOException {
        String scene = SCENE.replace("SLOWEST", "0 m/s")
                .replace(
                        "speed: 10 m/s",
                        "speed: 10 m/s, soundLevel: 90 dB, glideReduction: 90 dB,"
                                + " performance: {glideRatio: 8, glideSpeed: 10 m/s}")
                .replace(
                        "run: {",
                        "  ear: {kind: acoustic, position: [0, 0, 1],"
                                + " propagation: {kind: level-model, initialRays: 1, maxOrder: 1}}\nrun: {");
        UnseenPlaces alike = places(15.0, "0 m/s", 2);

        assertThat(places(scene, 15.0, 2, List.of(FlightMode.Kind.POWERED)))
                .isEqualTo(new UnseenPlaces(alike.tried(), 0));
        assertThat(places(scene, 15.0, 2, List.of(FlightMode.Kind.GLIDE))).isEqualTo(alike);
        assertThat(places(scene, 15.0, 2, List.of(FlightMode.Kind.POWERED, FlightMode.Kind.GLIDE)))
                .isEqualTo(alike);
        assertThat(alike.unseen()).isPositive();
    }

    @Test
    void thereIsAtLeastOneMode() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> UnseenPlaces.of(List.of(), null))
                .withMessage("0 modes: there must be at least one");
    }

    /** With two rows of cells in the passage, the search knows of it. */
    @Thorough
    @Test
    void nothingIsMissingInCellsThatAreSmallEnough() throws IOException {
        assertThat(places(2.0, "0 m/s", 2).unseen()).isZero();
    }

    /** A drone that flies across the line of sight is detected nowhere, and the bound counts on nothing. */
    @Test
    void nothingIsMissingWhereTheBoundIsZeroAnyway() throws IOException {
        assertThat(places(15.0, "20 m/s", 2).unseen()).isZero();
    }
}
