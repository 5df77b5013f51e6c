package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Pattern;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import tools.jackson.databind.JsonNode;

/** A layout that relies on radio receivers says what remains of it where the drone transmits nothing. */
class PlaceSilentDroneTest {
    private static final String RECEIVERS =
            """
            scene: site.yaml
            budget: 2
            candidates:
              radio:
                sensor: {kind: rf, threshold: 12}
                price: 1
                places: [[-30, 0, 6], [30, 0, 6]]
            """;

    private static final String SILENT = "--set=drones.one.radio.control=autonomous";

    private static final String NOTHING =
            "Against a drone that transmits nothing (autonomous, or controlled by fibre), the layout's ";

    private static final String HINT =
            ". For the best layout against it, run place with --set drones.one.radio.control=autonomous";

    @TempDir
    private Path directory;

    private Path file;

    @BeforeEach
    void write() throws IOException {
        FieldSite.in(directory, FieldSite.ROUND + "alert: {protect: {centre: [0, 0, 15], radius: 30}}\n");
        file = directory.resolve("radio.place.yaml");
    }

    private PlacedLayout placed(String more, String... options) throws IOException {
        Files.writeString(file, RECEIVERS + more);
        return PlacedLayout.of(file, directory, options);
    }

    /** The radar that is kept is the scene's only sensor: it covers what that covers. */
    @Test
    void theOtherSensorsStillCoverTheirPart() throws IOException {
        PlacedLayout place =
                placed("keep: [round]\nair: {side: 400 m, cell: 80 m, heights: [10 m, 40 m]}\n", "--budgets=1");
        JsonNode json = place.promised();
        double remaining = json.get("silent_drone").get("value").asDouble();
        int receivers = json.get("chosen").size() - 1;
        String sentence = NOTHING
                + (receivers == 1 ? "radio receiver detects" : receivers + " radio receivers detect")
                + String.format(
                        Locale.ROOT,
                        " nothing: the layout then covers %.1f %%, averaged over eight headings",
                        100.0 * remaining)
                + HINT;

        assertThat(receivers).isPositive();
        assertThat(json.get("silent_drone").get("receivers")).hasSize(receivers);
        assertThat(remaining)
                .isLessThan(json.get("value").asDouble())
                .isCloseTo(json.get("present").get("value").asDouble(), within(1e-9));
        assertThat(place.outcome().out().lines()).contains(sentence);
        assertThat(Files.readString(directory.resolve("report.html")))
                .containsPattern("class=\"verdict\">[^<]*" + Pattern.quote(sentence));
    }

    @Thorough
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "air: {side: 400 m, cell: 80 m, heights: [10 m]} | : the layout then covers 0.0 %, averaged over eight"
                        + " headings",
                "objective: warning-time\\nwarning: mean\\nair: {side: 400 m, cell: 40 m, heights: [40 m]}"
                        + " | : the layout then gives a mean warning of 0.0 s",
                "objective: weakest-route\\nair: {side: 240 m, cell: 40 m, heights: [30 m]}"
                        + " | : the layout then detects the drone with a probability of 0.0 % on the weakest route past it",
                "objective: weakest-route\\nkeep: [round]\\nair: {side: 240 m, cell: 40 m, heights: [30 m]}"
                        + " | : only its other sensor counts"
            })
    void everyObjectiveSaysSo(String lines, String remaining) throws IOException {
        String more = lines.replace("\\n", "\n") + "\n";
        // Receivers that miss nothing: there is no route past them.
        Files.writeString(file, RECEIVERS.replace("threshold: 12", "threshold: -30") + more);
        Outcome talking = Program.run("place", file.toString(), "--budgets=1");

        assertThat(talking.out()).as(talking.err()).contains(NOTHING, remaining + HINT);
    }

    @Test
    void aDroneThatTransmitsNothingAnywayIsNotMentioned() throws IOException {
        PlacedLayout silent =
                placed("keep: [round]\nair: {side: 400 m, cell: 80 m, heights: [10 m]}\n", "--budgets=1", SILENT);

        assertThat(silent.outcome().out()).doesNotContain("transmits nothing");
        assertThat(silent.promised().has("silent_drone")).isFalse();
    }
}
