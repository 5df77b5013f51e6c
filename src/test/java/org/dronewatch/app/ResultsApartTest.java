package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** A directory with the results of one command is left as it is by all others. */
class ResultsApartTest {
    private static final List<String> COMMANDS = List.of("run", "coverage", "route", "place", "campaign");
    private static final List<String> SIGNS =
            List.of("result.json", "coverage.json", "route.json", "place.json", "plan.json");

    @TempDir
    private static Path directory;

    private static Path placement;
    private static Path campaign;

    @BeforeAll
    static void write() throws IOException {
        placement = PlacedSite.in(directory, "budget: 6\n");
        campaign = Files.writeString(directory.resolve("few.campaign.yaml"), "scene: site.yaml\nruns: 2\n");
    }

    private static Stream<Arguments> pairs() {
        List<Arguments> pairs = new ArrayList<>();
        for (String command : COMMANDS) {
            SIGNS.stream()
                    .filter(sign -> SIGNS.indexOf(sign) != COMMANDS.indexOf(command))
                    .forEach(sign -> pairs.add(Arguments.of(command, sign)));
        }
        pairs.add(Arguments.of("route", "campaign.json"));
        return pairs.stream();
    }

    @ParameterizedTest
    @MethodSource("pairs")
    void theResultsOfAnotherCommandStay(String command, String sign) throws IOException {
        Path file =
                switch (command) {
                    case "place" -> placement;
                    case "campaign" -> campaign;
                    default -> directory.resolve("site.yaml");
                };
        Path out = Files.createDirectory(directory.resolve(command + "-" + sign));
        Files.writeString(out.resolve(sign), "{}");

        Outcome outcome = Program.run(command, file.toString(), "--out=" + out);

        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.complaints()).hasSize(1);
        assertThat(outcome.complaints().get(0)).contains(out.toString(), "choose ");
        if (!command.equals("campaign")) {
            assertThat(outcome.complaints().get(0)).contains(" holds the results of ", "(" + sign + ")");
        }
        try (Stream<Path> files = Files.list(out)) {
            assertThat(files).containsExactly(out.resolve(sign));
        }
        assertThat(out.resolve(sign)).hasContent("{}");
    }
}
