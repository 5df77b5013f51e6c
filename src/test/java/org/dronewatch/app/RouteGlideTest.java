package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A drone that can stop its motors, before a microphone: from the command to the files. */
class RouteGlideTest {
    /** A microphone does not hear a glider: its motors stop and stay off, flights agree, and all is repeatable. */
    @Thorough
    @Test
    void motorsStopWhereTheyWouldBeHeard(@TempDir Path other) throws IOException {
        FieldSite.in(
                other,
                "  ear: {kind: acoustic, position: [0, 0, 4],"
                        + " propagation: {kind: level-model, initialRays: 1, maxOrder: 1}}\n"
                        + "alert: {protect: {centre: [0, 0, 10], radius: 30}, response: 5 s}\n");
        Path site = other.resolve("site.yaml");
        Files.writeString(
                site,
                Files.readString(site)
                        .replaceFirst("  one:\n", "  one:\n    performance: {glideRatio: 8, glideSpeed: 10 m/s}\n"));
        Outcome glided = Program.run(
                "route",
                site.toString(),
                "--heights=10,20,30,45",
                "--side=500",
                "--cell=50",
                "--set=drones.one.soundLevel=43",
                "--stopped=0.8",
                "--proof=20",
                "--out=" + other.resolve("glided"));
        assertThat(glided.code()).as(glided.err()).isZero();
        assertThat(glided.out()).contains("motors off", "stopped", "with its motors off for the last");
        JsonNode found = JsonMapper.builder()
                .build()
                .readTree(other.resolve("glided/route.json").toFile());
        assertThat(glided.err())
                .containsPattern(
                        "no scenes of the routes are written: world\\.models\\.0\\.file: .* cannot name it; use"
                                + " --out " + other + "\\R");
        assertThat(found.get("modes")).extracting(JsonNode::asString).containsExactly("powered", "glide");
        int glides = 0;
        for (JsonNode route : found.get("routes")) {
            JsonNode proof = route.get("proof");
            assertThat(proof.propertyNames())
                    .containsExactly("runs", "k", "low", "high", "predicted", "agrees", "in_time");
            // Its first detection is an alert.
            assertThat(proof.get("in_time").get("predicted").asDouble())
                    .isCloseTo(route.get("p_in_time").asDouble(), within(1e-5));
            assertThat(proof.get("in_time").get("agrees").asBoolean()).isTrue();
            assertThat(proof.get("runs").asInt()).isEqualTo(20);
            assertThat(route.get("p_detect").asDouble())
                    .isCloseTo(proof.get("predicted").asDouble(), within(1e-5));
            assertThat(proof.get("agrees").asBoolean()).isTrue();
            assertThat(route.get("p_e").asDouble())
                    .isCloseTo(0.8 * route.get("p_i").asDouble(), within(1e-5));
            JsonNode before = null;
            for (JsonNode point : route.get("points")) {
                if (before != null && before.get("mode").asString().equals("glide")) {
                    assertThat(point.get("mode").asString()).isEqualTo("glide");
                    assertThat(point.get("z").asDouble())
                            .isLessThan(before.get("z").asDouble());
                    glides++;
                }
                before = point;
            }
        }
        assertThat(glides).isPositive();
        Outcome again =
                Program.run("again", other.resolve("glided/provenance.json").toString());
        assertThat(again.code()).as(again.out() + again.err()).isZero();
        assertThat(again.out())
                .contains("same       route.json", "same       routes.png", "same       time-to-go.png")
                .contains("same       view.png", "same       profile.png");
    }
}
