package org.dronewatch.app.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What commands that may take minutes say beside their results, where there is no terminal. */
class ProgressOptionsTest {
    private static final String PLACE = "place radars.place.yaml";
    private static final String COVERAGE = "coverage site.yaml --side=100 --cell=50 --heights=10";
    private static final String ROUTE = "route site.yaml --side=200 --cell=40 --heights=10";
    private static final String CAMPAIGN = "campaign few.campaign.yaml --out=new";
    private static final String COMPARE = "compare site.yaml --with=sensors.round.maxRange=10 --runs=1 --out=new";

    @TempDir
    private static Path directory;

    @BeforeAll
    static void write() throws IOException {
        PlacedSite.in(directory, "budget: 4\n");
        Files.writeString(directory.resolve("few.campaign.yaml"), "scene: site.yaml\nruns: 2\n");
    }

    /** Runs a command whose files and new directories are in that of the test. */
    private static Outcome run(String command, String... more) {
        String there = directory + "/";
        String out = there + "results-" + System.nanoTime();
        Stream<String> words = Stream.of(command.split(" "))
                .map(word -> word.endsWith(".yaml") ? there + word : word.replace("=new", "=" + out));
        Outcome outcome = Program.run(
                Stream.concat(words, Stream.of(more)).map(String::valueOf).toArray(String[]::new));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return outcome;
    }

    @Thorough
    @ParameterizedTest
    @CsvSource({PLACE, COVERAGE, ROUTE, CAMPAIGN, COMPARE})
    void quietCommandsPrintNothingButResults(String command) {
        Outcome quiet = run(command, "--quiet");

        assertThat(quiet.err()).isEmpty();
        assertThat(quiet.out()).isNotBlank().isEqualTo(run(command).out());
    }

    @Thorough
    @ParameterizedTest
    @CsvSource({
        PLACE + ", coverage of candidates: done after",
        COVERAGE + ", coverage: done after",
        ROUTE + ", detection field: done after",
        CAMPAIGN + ", 2 of 2 cases after",
        COMPARE + ", 1 of 1 case after"
    })
    void progressIsShownWithoutATerminal(String command, String line) {
        assertThat(run(command, "--progress").err().lines()).anyMatch(one -> one.startsWith(line));
        assertThat(run(command).err()).doesNotContain(line);
    }

    @ParameterizedTest
    @CsvSource({PLACE, COVERAGE, ROUTE, CAMPAIGN, COMPARE})
    void bothAtOnceAreRefused(String command) {
        List<String> words = List.of(command.split(" "));
        Outcome refused = Program.run(Stream.concat(words.stream(), Stream.of("--quiet", "--progress"))
                .toArray(String[]::new));

        assertThat(refused.code()).isEqualTo(2);
        assertThat(refused.err().strip()).isEqualTo("--quiet: cannot be combined with --progress");
    }
}
