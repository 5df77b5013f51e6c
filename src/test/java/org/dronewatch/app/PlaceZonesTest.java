package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ObjectNode;

/** {@code place} where some zones count more than the rest of the airspace. */
class PlaceZonesTest {
    /** One east of all boxes, and one west of them. */
    private static final String ZONES =
            """
            alert:
              protect: {centre: [0, 0, 10], radius: 30 m}
              zones:
                depot: {area: [[100, -200], [200, -200], [200, 200], [100, 200]], height: 100}
                gate: {area: [[-200, -200], [-100, -200], [-100, 200], [-200, 200]], height: 100}
            """;

    @TempDir
    private Path directory;

    private Path file(String weights, String more) throws IOException {
        Path file = PlacedSite.in(directory, more);
        Files.writeString(directory.resolve("site.yaml"), ZONES, StandardOpenOption.APPEND);
        return Files.writeString(file, Files.readString(file).replace("air: {", "air: {" + weights));
    }

    private Outcome place(String weights, String more, String... options) throws IOException {
        Path file = file(weights, more);
        String[] words = new String[options.length + 4];
        System.arraycopy(options, 0, words, 4, options.length);
        System.arraycopy(new String[] {"place", file.toString(), "--budgets=1", "--quiet"}, 0, words, 0, 4);
        return Program.run(words);
    }

    private ObjectNode json(String weights, String more) throws IOException {
        Outcome outcome = place(weights, more, "--json");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return (ObjectNode) JsonMapper.builder().build().readTree(outcome.out());
    }

    @Test
    void weightsDecideWhichZoneIsCovered() throws IOException {
        JsonNode east = json("weights: {depot: 50, gate: 0}, ", "budget: 1.5\n");
        JsonNode west = json("weights: {depot: 0, gate: 50}, ", "budget: 1.5\n");

        assertThat(east.at("/zones/0/zone").asString()).isEqualTo("depot");
        assertThat(east.at("/zones/1/zone").asString()).isEqualTo("gate");
        assertThat(east.at("/zones/2/zone").isNull()).isTrue();
        assertThat(east.at("/zones/0/layout").asDouble())
                .isGreaterThan(west.at("/zones/0/layout").asDouble());
        assertThat(east.at("/zones/1/layout").asDouble())
                .isLessThan(west.at("/zones/1/layout").asDouble());
        assertThat(east.at("/chosen/0/sensor")).isNotEqualTo(west.at("/chosen/0/sensor"));
        assertThat(east.at("/zones/0/present")).isEqualTo(west.at("/zones/0/present"));
    }

    @Test
    void weightsOfOneChangeNothing() throws IOException {
        ObjectNode without = json("", "budget: 6\n");
        ObjectNode with = json("weights: {depot: 1, protected: 1}, ", "budget: 6\n");

        assertThat(with.has("zones")).isTrue();
        with.remove("zones");
        assertThat(with).isEqualTo(without);
    }

    @Test
    void thePrintedTableAndTheReportNameTheWeights() throws IOException {
        Outcome outcome = place("weights: {depot: 4.5}, ", "budget: 6\n", "--out=" + directory);
        String report = Files.readString(directory.resolve("report.html"));

        assertThat(outcome.out())
                .containsPattern(
                        "The layout covers \\d+\\.\\d % of the weighted airspace, averaged over eight headings \\(")
                .contains("coverage of each zone, unweighted, in % of its cells, averaged over eight headings:")
                .containsPattern("(?m)^ +depot +4\\.5 +\\d+ +\\d+\\.\\d +\\d+\\.\\d$")
                .containsPattern("(?m)^ +all other cells +1 +\\d+ +\\d+\\.\\d +\\d+\\.\\d$");
        assertThat(report).contains("Coverage by zone", "<td>depot</td>", "of the weighted airspace");
        assertThat(place("", "budget: 6\n").out()).doesNotContain("weighted");
    }

    /** The sum of weights that are no whole numbers is rounded; all of it is still all. */
    @Test
    void allOfTheAirspaceIsAHundredPercent() throws IOException {
        Path file = file("weights: {depot: 0.7, gate: 3.1, protected: 11.3}, ", "budget: 3\n");
        // Receivers that miss nothing.
        Files.writeString(file, Files.readString(file).replace("threshold: 12", "threshold: -50"));
        Outcome outcome = Program.run("place", file.toString(), "--budgets=1", "--quiet");

        assertThat(outcome.out())
                .as(outcome.err())
                .contains("The layout covers 100.0 % of the weighted airspace")
                .doesNotContain("> 99.9 %");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "weights: {depo: 2} | budget: 3 | air.weights depo: no such zone; the scene protects depot, gate,"
                        + " protected; did you mean 'depot'?",
                "weights: {protected: 2}, area: depot | budget: 3 | air.weights protected: no cell of the airspace has"
                        + " its centre in this zone",
                "weights: {depot: -1} | budget: 3 | air.weights: depot -1: must be 0 to 1000",
                "weights: {depot: 1001} | budget: 3 | air.weights: depot 1001: must be 0 to 1000",
                "weights: {depot: much} | budget: 3 | depot",
                "weights: {depot: 0}, area: depot | budget: 3 | air.weights: all cells have a weight of 0; at least one"
                        + " must have more",
                "weights: {depot: 2} | objective: warning-time\\nbudget: 3 | air.weights: has no meaning for the"
                        + " objective warning-time: its value is not a sum over cells",
                "weights: {depot: 2} | objective: weakest-route\\nbudget: 3 | air.weights: has no meaning for the"
                        + " objective weakest-route: its value is not a sum over cells"
            })
    void otherWeightsAreRefused(String weights, String more, String message) throws IOException {
        Outcome outcome = place(weights + ", ", more.replace("\\n", "\n") + "\n");

        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err().strip()).contains(message).doesNotContain("\n");
        assertThat(outcome.out()).isEmpty();
    }
}
