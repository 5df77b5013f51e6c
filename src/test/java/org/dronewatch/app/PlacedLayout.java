package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.dronewatch.app.Program.Outcome;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * What {@code place} has found, and what other commands say of it.
 *
 * @param directory of its files
 * @param outcome what it printed
 */
record PlacedLayout(Path directory, Outcome outcome) {
    /** Runs {@code place}, which must succeed, with a directory for its files. */
    static PlacedLayout of(Path file, Path directory, String... more) {
        List<String> words = new ArrayList<>(List.of("place", file.toString(), "--out=" + directory));
        words.addAll(Arrays.asList(more));
        Outcome outcome = Program.run(words.toArray(String[]::new));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return new PlacedLayout(directory, outcome);
    }

    /** What it promises, {@code place.json}. */
    JsonNode promised() {
        return JsonMapper.builder()
                .build()
                .readTree(directory.resolve("place.json").toFile());
    }

    /** Runs the command that it prints for the layout, word for word, with more options. */
    Outcome again(String command, String... more) {
        List<String> words = new ArrayList<>(ShellWords.printed(outcome.out(), command));
        words.addAll(Arrays.asList(more));
        Outcome again = Program.run(words.toArray(String[]::new));
        assertThat(again.code()).as(again.err()).isZero();
        return again;
    }

    /** The same as a JSON object. */
    JsonNode json(String command, String... more) {
        List<String> options = new ArrayList<>(List.of("--json"));
        options.addAll(Arrays.asList(more));
        return JsonMapper.builder()
                .build()
                .readTree(again(command, options.toArray(String[]::new)).out());
    }

    /** The share of the known cells that the layout covers, as {@code coverage} says. */
    double coveredShare() {
        double known = 0.0;
        double covered = 0.0;
        for (JsonNode height : json("coverage").get("heights")) {
            known += height.get("known").asDouble();
            covered +=
                    height.get("covered_share").asDouble() * height.get("known").asDouble();
        }
        return covered / known;
    }
}
