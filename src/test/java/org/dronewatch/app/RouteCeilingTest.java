package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** {@code route} searches up to the drone's ceiling, and says so where it does not. */
class RouteCeilingTest {
    private static final String NOTE = "Routes more than %s m above the ground were not searched for, although the"
            + " drone's ceiling is %s m; to include them, add higher --heights.";

    @TempDir
    private Path directory;

    private static final String SCENE =
            """
            world: {models: [{file: ground.obj, upAxis: z, role: terrain}]}
            drones:
              high:
                model: packaged:quadrotor.obj
                speed: 14 m/s
                radar: {crossSection: 0.01 m2}
                flight: {kind: approach, from: [0, 290, 40], to: [0, 0, 20]}
            sensors:
              radar:
                kind: radar
                position: [0, 0, 3]
                elevationWidth: 70 deg
                rate: 2 Hz
                minSpeed: 0 m/s
                minRange: 1 m
                budget: {kind: data-sheet, range: 1500 m, crossSection: 0.01 m2}
                detection: {kind: chance, falseAlarm: 1e-6}
            alert: {protect: {centre: [0, 0, 0], radius: 30 m}, response: 5 s}
            run: {duration: 20 s}
            """;

    @BeforeEach
    void write() throws IOException {
        Files.writeString(
                directory.resolve("ground.obj"),
                "o ground\nv -900 -900 0\nv 900 -900 0\nv 900 900 0\nv -900 900 0\nf 1 2 3\nf 1 3 4\n");
    }

    private JsonNode route(String scene, int cell, String... more) throws IOException {
        Path file = Files.writeString(directory.resolve("high.yaml"), scene);
        List<String> words =
                new ArrayList<>(List.of("route", file.toString(), "--side=600m", "--cell=" + cell, "--json"));
        words.addAll(List.of(more));
        Outcome outcome = Program.run(words.toArray(String[]::new));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return JsonMapper.builder().build().readTree(outcome.out());
    }

    private static List<String> notes(JsonNode found) {
        List<String> notes = new ArrayList<>();
        found.get("notes").forEach(note -> notes.add(note.asString()));
        return notes;
    }

    /** The radar's beam reaches 35° above the horizon: a drone that comes at 500 m is over it, and then in its cone. */
    @Test
    void aFlightOverTheBeamIsFound() throws IOException {
        JsonNode low = route(SCENE, 120, "--heights=10,20,30,45,60,90,120,150");
        JsonNode found = route(SCENE, 120);

        assertThat(low.get("routes")).allMatch(route -> route.get("p_in_time").asDouble() > 0.99);
        assertThat(notes(low)).containsOnlyOnce(NOTE.formatted("150", "500"));
        assertThat(found.get("routes"))
                .hasSize(8)
                .allMatch(route -> route.get("p_in_time").asDouble() < 1e-3);
        assertThat(notes(found)).noneMatch(note -> note.contains("ceiling"));
        assertThat(notes(low)).noneMatch(note -> note.contains("starts more than"));
        assertThat(notes(found))
                .containsOnlyOnce(
                        "On the routes from all directions, the drone starts more than 150 m above the ground at"
                                + " the edge of the area. Detections farther out do not count; to count them, try"
                                + " a larger --side.");
        assertThat(found.get("heights_m").get(0).asDouble()).isEqualTo(2.0);
        assertThat(found.get("heights_m").get(11).asDouble()).isEqualTo(500.0);
    }

    /** Heights above the ceiling are not searched, and thus not the air between the one below it and the ceiling. */
    @Test
    void whatIsNotSearchedBelowTheCeilingIsStated() throws IOException {
        String limited = SCENE.replace("speed: 14 m/s", "speed: 14 m/s\n    performance: {ceiling: 120 m}");

        assertThat(route(limited, 120).get("heights_m"))
                .hasSize(9)
                .last()
                .isEqualTo(JsonMapper.builder().build().readTree("120"));
        assertThat(notes(route(limited, 120, "--heights=20,120"))).noneMatch(note -> note.contains("ceiling"));
        assertThat(notes(route(limited, 120, "--heights=20,60,150"))).containsOnlyOnce(NOTE.formatted("60", "120"));
    }

    /** The drones of a swarm have no settings of their own in the scene: their ceiling is that of their leader. */
    @Test
    void aDroneOfASwarmHasACeiling() throws IOException {
        String swarm = SCENE.replace("speed: 14 m/s", "speed: 14 m/s\n    swarm: {count: 2, spacing: 5 m}");

        assertThat(notes(route(swarm, 120, "--heights=20,60"))).containsOnlyOnce(NOTE.formatted("60", "500"));
    }

    /** Where the radar sees all but its cone, the bound is not lost because the highest levels are far apart. */
    @Test
    void theLowerBoundRemainsUsefulUpToTheCeiling() throws IOException {
        String dome = SCENE.replace("elevationWidth: 70 deg", "elevationWidth: 178 deg");

        for (JsonNode route : route(dome, 50).get("routes")) {
            assertThat(route.get("lower").asDouble())
                    .isGreaterThan(0.2 * route.get("upper").asDouble());
        }
    }
}
