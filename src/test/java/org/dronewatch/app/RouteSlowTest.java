package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A drone that can hover before a radar that rejects low radial speeds: from the command to the files. */
class RouteSlowTest {
    private static final String SITE =
            """
            world:
              models: [{file: plain.obj, upAxis: z, role: terrain}]
            drones:
              intruder:
                model: packaged:quadrotor.obj
                speed: 12 m/s
                radar: {crossSection: 0.01}
                flight: {kind: hover, position: [0, 300, 40]}
            sensors:
              tower: {kind: radar, position: [0, 0, 4], minRange: 1, maxRange: 900, elevationWidth: 170 deg, rate: 1, minSpeed: 3 m/s,
                budget: {range: 250, crossSection: 0.01}}
            alert: {protect: {centre: [0, 0, 10], radius: 25}}
            run: {duration: 1 s, seed: 7}
            """;

    @TempDir
    private Path directory;

    private Outcome search(int cell, String... options) throws IOException {
        Path site = directory.resolve("site.yaml");
        Files.writeString(
                directory.resolve("plain.obj"), "v -400 -400 0\nv 400 -400 0\nv 400 400 0\nv -400 400 0\nf 1 2 3 4\n");
        Files.writeString(site, SITE);
        String[] all = new String[options.length + 5];
        System.arraycopy(
                new String[] {"route", site.toString(), "--side=700", "--cell=" + cell, "--heights=5,20,40"},
                0,
                all,
                0,
                5);
        System.arraycopy(options, 0, all, 5, options.length);
        return Program.run(all);
    }

    @Test
    void itSlowsDownWhereTheRadarSeesIt() throws IOException {
        Outcome slow = search(25, "--proof=10", "--out=" + directory.resolve("slow"));

        assertThat(slow.code()).as(slow.err()).isZero();
        assertThat(slow.out())
                .containsPattern("time left +slow +most exposed to")
                .contains("flying at 2.97 m/s, which a radar rejects, for ", "no sensor detects it on the way");
        JsonNode found = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("slow/route.json").toFile());
        assertThat(found.get("modes")).extracting(JsonNode::asString).containsExactly("powered", "slow");
        assertThat(found.get("routes")).hasSize(8).allSatisfy(route -> {
            assertThat(route.get("proof").get("k").asInt()).isZero();
            assertThat(route.get("p_detect").asDouble()).isZero();
            assertThat(route.get("points"))
                    .extracting(point -> point.get("mode").asString())
                    .contains("slow");
            assertThat(slowestLeg(route.get("points"))).isCloseTo(0.99 * 3.0, within(1e-3));
        });
        assertThat(Files.readString(directory.resolve("slow/report.html")))
                .contains("may slow down to 2.97 m/s at any time", "'slow' is how long the drone flies at 2.97 m/s");
    }

    /** Along its path, m/s. */
    private static double slowestLeg(JsonNode points) {
        double slowest = Double.POSITIVE_INFINITY;
        for (int i = 1; i < points.size(); i++) {
            double time = difference(points, i, "t");
            double length = Math.sqrt(square(difference(points, i, "x"))
                    + square(difference(points, i, "y"))
                    + square(difference(points, i, "z")));
            slowest = Math.min(slowest, length / time);
        }
        return slowest;
    }

    private static double difference(JsonNode points, int i, String name) {
        return points.get(i).get(name).asDouble() - points.get(i - 1).get(name).asDouble();
    }

    private static double square(double value) {
        return value * value;
    }

    @Thorough
    @Test
    void atFullSpeedItIsDetected() throws IOException {
        Outcome fast = search(50, "--modes=powered");

        assertThat(fast.code()).as(fast.err()).isZero();
        assertThat(fast.out())
                .containsPattern("time left +most exposed to")
                .doesNotContain("2.97 m/s")
                .contains("100 %  ");
    }

    @Test
    void aModeThatMakesNoDifferenceIsRefusedInOneLine() throws IOException {
        Outcome seen = search(25, "--modes=powered,slow", "--set=sensors.tower.minSpeed=0 m/s");
        Outcome winged = search(25, "--modes=slow", "--set=drones.intruder.airframe=fixed-wing");

        assertThat(seen.code()).isEqualTo(2);
        assertThat(seen.err())
                .contains(
                        "--modes powered,slow: slow flight makes no difference: no sensor of the scene detects the drone");
        assertThat(winged.code()).isEqualTo(2);
        assertThat(winged.err()).contains("--modes slow: the drone cannot fly slowly; performance.hover is false");
    }
}
