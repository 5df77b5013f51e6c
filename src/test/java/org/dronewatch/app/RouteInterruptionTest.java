package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Child;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * A request to end while {@code route} repeats its search because of what its looks have shown: the best routes so
 * far, whole.
 */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "there a process can only be killed")
class RouteInterruptionTest {
    /** A ring around the zone, which the drone must cross, lies between the middles of cells of 40 m. */
    private static final String SCENE =
            """
            world:
              models: [{file: plain.obj, role: terrain}]
            drones:
              one: {model: 'packaged:quadrotor.obj', speed: 12 m/s, flight: {kind: hover, position: [0, 300, 40]}}
            sensors:
              ring: {kind: radar, position: [0, 0, 4], minRange: 31, maxRange: 60, elevationWidth: 90 deg,
                minSpeed: 0 m/s, budget: {range: 5000, crossSection: 0.01}}
            alert: {protect: {centre: [0, 0, 10], radius: 30}}
            run: {duration: 1 s, seed: 7}
            """;

    @TempDir
    private Path directory;

    @Thorough
    @Test
    void theBestRoutesSoFarAreWhole() throws Exception {
        Files.writeString(
                directory.resolve("plain.obj"),
                "v -500 0 -500\nv 500 0 -500\nv 500 0 500\nv -500 0 500\nf 1 4 3\nf 1 3 2\n");
        Files.writeString(directory.resolve("site.yaml"), SCENE);
        String heights =
                IntStream.rangeClosed(10, 30).mapToObj(height -> height + "m").collect(Collectors.joining(","));
        Outcome outcome;
        try (Child route = Program.start(
                directory,
                List.of("-Xmx1g", "-XX:+UseSerialGC"),
                ("route site.yaml --side 960m --cell 40m --threads 1 --progress --out . --heights " + heights)
                        .split(" "))) {
            awaitText(route.err(), "looks along the routes: done");
            // Not SIGINT, which a build in the background ignores, and with it all that it starts.
            route.process().destroy();
            outcome = route.await();
        }

        assertThat(outcome.err())
                .doesNotContain("repeated search for routes: done")
                .doesNotContain("error")
                .doesNotContain("Exception")
                .contains(
                        "interrupted: there are routes from all directions, but not all searches and flights are complete");
        assertThat(outcome.code()).as(outcome.err()).isEqualTo(143);
        assertThat(outcome.out()).contains("On the weakest route, the drone comes from the ");
        JsonNode json = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("route.json").toFile());
        assertThat(json.get("complete").asBoolean()).isFalse();
        assertThat(json.get("routes")).hasSize(8);
        for (JsonNode route : json.get("routes")) {
            assertThat(route.get("p_detect").asDouble()).isGreaterThan(0.9);
            Path scene = directory.resolve("route-" + route.get("sector").asString() + ".yaml");
            assertThat(Program.run("check", scene.toString()).code()).isZero();
        }
        assertThat(directory.resolve("report.html")).content().endsWith("</html>\n");
        assertThat(directory.resolve("provenance.json")).isNotEmptyFile();
        try (Stream<Path> left = Files.list(directory)) {
            assertThat(left.map(one -> one.getFileName().toString())).noneMatch(name -> name.startsWith(".partial"));
        }
    }

    private static void awaitText(Path file, String text) throws IOException, InterruptedException {
        long end = System.nanoTime() + TimeUnit.MINUTES.toNanos(2);
        while (!Files.readString(file).contains(text)) {
            if (System.nanoTime() > end) {
                throw new AssertionError("waited for two minutes for: " + text);
            }
            Thread.sleep(5);
        }
    }
}
