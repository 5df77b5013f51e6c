package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.proof.FlownRoute;
import org.dronewatch.route.proof.RouteScene;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * On a plain, a camera looks south. At the limit of its range, whether it sees a drone depends on how its outline meets
 * the pixels: it misses it in the middles of some cells, and the route that leads over these is detected elsewhere.
 */
class RouteAgainTest {
    private static final double RESPONSE = 3.0;
    private static final int SOUTH = 4;

    private static final String SCENE =
            """
            world: {models: [{file: plain.obj, upAxis: z, role: terrain}]}
            drones:
              d: {model: packaged:quadrotor.obj, speed: 12 m/s, flight: {kind: hover, position: [0, 0, 30]}}
            sensors:
              cam: {kind: camera, position: [0, -40, 12], aim: {azimuth: 180 deg, elevation: 5 deg}, fov: 60 deg, rate: 5}
            alert:
              zones: {yard: {centre: [0, 0], radius: 40 m, height: 30 m}}
              response: 3 s
            run: {duration: 60 s}
            """;

    @TempDir
    private Path directory;

    private Path scene;

    @BeforeEach
    void write() throws IOException {
        Files.writeString(
                directory.resolve("plain.obj"), "v -300 -300 0\nv 300 -300 0\nv 300 300 0\nv -300 300 0\nf 1 2 3 4\n");
        scene = directory.resolve("scene.yaml");
        Files.writeString(scene, SCENE);
    }

    private Outcome route(String... more) {
        String[] words = new String[more.length + 5];
        System.arraycopy(
                new String[] {"route", scene.toString(), "--side=400", "--cell=20", "--heights=10,25,45"},
                0,
                words,
                0,
                5);
        System.arraycopy(more, 0, words, 5, more.length);
        Outcome outcome = Program.run(words);
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome;
    }

    /** The route of the search alone, as flown. */
    private SectorRoute searchedOnce() {
        SceneRunner runner = new SceneRunner(new SceneFile(scene));
        SceneSettings settings = runner.settings();
        Stage stage = runner.stage(settings);
        FieldGrid grid = new FieldGrid(0.0, 0.0, 400.0, 20.0, List.of(10.0, 25.0, 45.0));
        DetectionField field = FieldAssessment.of(
                settings,
                stage,
                "d",
                grid,
                Course.all(settings.enabledSensors(), DetectionField.droneOf(stage, "d")),
                FieldTerms.ONE_LOOK,
                progress -> {});
        SiteRoutes routes = SiteRoutes.of(field, settings, stage, "d");
        SectorRoute route = routes.describe(SOUTH, routes.from(SOUTH).orElseThrow());
        SceneSettings flight =
                RouteScene.of(settings, "d", routes.flight(route.route()).orElseThrow());
        return route.with(FlownRoute.of(flight, runner.load(flight)).exposure());
    }

    @Thorough
    @Test
    void aRouteThatFlightsDetectIsSearchedForAgain() {
        assertThat(searchedOnce().isUnderestimated(RESPONSE)).isTrue();

        Path out = directory.resolve("out");
        Outcome outcome = route("--proof=20", "--out=" + out);
        JsonNode south = JsonMapper.builder()
                .build()
                .readTree(out.resolve("route.json").toFile())
                .get("routes")
                .get(SOUTH);

        assertThat(south.get("sector").asString()).isEqualTo("south");
        assertThat(outcome.err()).doesNotContain("misjudges");
        assertThat(outcome.out()).containsPattern("(?m)^south +[0-9.]+ s +0 +0 +0 % +0 % ");
        assertThat(south.get("p_in_time").asDouble()).isZero();
        assertThat(south.get("proof").get("k").asInt()).isZero();
    }

    @Test
    void theNumberOfThreadsChangesNothing() {
        assertThat(route("--quiet", "--threads=1").out())
                .isEqualTo(route("--quiet", "--threads=3").out());
    }
}
