package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What the results of {@code route} leave out: numbers that flights cannot give, and directions without a route. */
class RouteGapsTest {
    private static final String SENSORS = FieldSite.ROUND
            + "  turning: {kind: camera, position: [3, 0, 4], fov: 6 deg, width: 640, height: 480,"
            + " positioner: {cues: [round]}}\n"
            + "alert: {protect: {centre: [0, 0, 10], radius: 30}, response: 5 s}\n";

    @TempDir
    private static Path directory;

    @BeforeAll
    static void write() throws IOException {
        FieldSite.in(directory, SENSORS);
    }

    private static Outcome route(String pointing, String... more) {
        List<String> words = new ArrayList<>(List.of(
                "route",
                directory.resolve("site.yaml").toString(),
                "--heights=10",
                "--stopped=0.5",
                "--pointing=" + pointing));
        words.addAll(List.of(more));
        if (words.stream().noneMatch(word -> word.startsWith("--side"))) {
            words.addAll(List.of("--side=400", "--cell=50m"));
        }
        Outcome outcome = Program.run(words.toArray(String[]::new));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome;
    }

    @Test
    void whileACameraSearchesAnAlertInTimeIsStated() {
        assertThat(route("search").out()).contains("alert in time").doesNotContain("cannot be computed");
    }

    /** Flights have no cues: what comes from them is not mixed with the numbers of a camera that is cued. */
    @Test
    void whereItIsCuedTheSearchAloneIsStated() {
        Path out = directory.resolve("cued");
        String text = route("cued", "--launch={centre: [150, 120], radius: 30}", "--out=" + out)
                .out();

        assertThat(text)
                .doesNotContain("alert in time")
                .contains(
                        "The probability that an alert comes in time cannot be computed where sensors on positioners count"
                                + " as cued: it is computed from flights without cues.")
                .contains("south-west: no route");
        JsonNode routes = JsonMapper.builder()
                .build()
                .readTree(out.resolve("route.json").toFile())
                .get("routes");
        assertThat(routes).hasSize(1);
        JsonNode route = routes.get(0);
        assertThat(route.get("sector").asString()).isEqualTo("north-east");
        assertThat(route.get("p_i").isNull()).isTrue();
        assertThat(route.get("p_e").isNull()).isTrue();
        assertThat(route.get("p_detect").asDouble()).isPositive();
        assertThat(out.resolve("report.html"))
                .content()
                .contains("cannot be computed where sensors on positioners count as cued", "<th>from</th>")
                .doesNotContain("<th>alert in time")
                .containsPattern("south-west</td><td[^>]*>no route</td><td[^>]*>-</td>")
                .doesNotContainPattern("north-east</td><td[^>]*>no route");
    }

    /** The whole area is in the zone. */
    @Test
    void aRouteThatEndsWhereItBeginsIsNotTheWeakest() {
        Path out = directory.resolve("inside");
        String text = route("search", "--side=40", "--cell=10", "--out=" + out).out();

        assertThat(text)
                .doesNotContain("The weakest route")
                .contains("There is no weakest route: each ends where it begins, because the starting area touches"
                        + " the protected zone; try a larger --side.");
        assertThat(out.resolve("report.html")).content().contains("There is no weakest route");
        assertThat(out.resolve("profile.png")).doesNotExist();
    }
}
