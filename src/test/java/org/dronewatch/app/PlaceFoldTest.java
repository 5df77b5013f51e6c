package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A layout in which two sensors must cover a cell. */
class PlaceFoldTest {
    /** A line of the first table: what the sensors so far cover, %. */
    private static final Pattern PURCHASE =
            Pattern.compile("(?m)^(?:radar|radio|eye)-\\S+ .* [\\d.]+ +[\\d.]+ +[\\d.]+ % +([\\d.]+) %$");

    @TempDir
    private Path directory;

    @Thorough
    @Test
    void saysHowItWasOrderedAndThatTheTableCountsSingleSensors() throws IOException {
        Path file = PlacedSite.in(directory, "budget: 8\nconditions: {fold: 2}\n");
        Outcome outcome = Program.run("place", file.toString(), "--out=" + directory.resolve("."));

        assertThat(outcome.code()).as(outcome.err()).isZero();
        String page = Files.readString(directory.resolve("report.html"));
        assertThat(page).contains("the sensor that contributes least per unit of price was left out");
        List<MatchResult> purchases = PURCHASE.matcher(outcome.out()).results().toList();
        assertThat(purchases).hasSizeGreaterThan(2);
        // The first sensor covers nothing twice, but with the second, something is covered.
        assertThat(purchases.get(0).group(1)).isEqualTo("0.0");
        assertThat(Double.parseDouble(purchases.get(1).group(1))).isPositive();
        assertThat(outcome.out())
                .contains("coverage by one sensor or more on the heading that is worst in each cell")
                .contains("; the layout was chosen for what 2 sensors or more cover.")
                .contains("of the known cells with 2 sensors or more; the scene's own sensors cover 0.0 %.");
        assertThat(page)
                .contains("The table states the coverage by one sensor or more on the heading")
                .contains("; the layout was chosen for what 2 sensors or more cover.");
    }

    /** Keeping exactly what the scene has is worth what the scene's own sensors are worth, on the same terms. */
    @Thorough
    @ParameterizedTest
    @CsvSource({"1, worst", "1, mean", "2, worst", "2, mean"})
    void warningsOfTheSameSensorsAreTheSame(int fold, String measure) throws IOException {
        Path file = PlacedSite.in(
                directory,
                "budget: 0\nkeep: [round, radio]\nobjective: warning-time\nwarning: " + measure
                        + "\nconditions: {fold: " + fold + "}\n");
        FieldSite.in(
                directory,
                FieldSite.ROUND + "  radio: {kind: rf, position: [0, 5, 4], threshold: 12}\n"
                        + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        Outcome outcome = Program.run("place", file.toString(), "--quiet", "--out=" + directory);
        JsonNode json = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("place.json").toFile());

        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(json.at("/chosen")).hasSize(2);
        assertThat(json.at("/present/value")).isEqualTo(json.get("value"));
        assertThat(outcome.out()).doesNotContain("better than this layout");
        if (measure.equals("mean")) {
            assertThat(json.get("value").asDouble()).isPositive();
            assertThat(json.at("/chosen/0/alone").asDouble()).isPositive();
        }
        assertThat(json.get("detected").asInt())
                .isBetween(1, json.get("flights").asInt());
        assertThat(outcome.out().contains(", 2 sensors or more detect the drone before it arrives"))
                .isEqualTo(fold == 2);
        assertThat(outcome.out().contains("the layout was chosen for warnings that begin only when 2 sensors"))
                .isEqualTo(fold == 2);
    }
}
