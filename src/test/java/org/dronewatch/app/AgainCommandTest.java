package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.campaign.CampaignSite;
import org.dronewatch.report.provenance.RecordedCommand;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Results are repeated from their provenance, which is data that anybody may have written. */
class AgainCommandTest {
    @TempDir
    private static Path original;

    @TempDir
    private Path directory;

    private Path provenance;

    @BeforeAll
    static void run() throws IOException {
        CampaignSite.in(original, CampaignSite.TWO_RANGES);
        Outcome outcome = Program.run(
                "run",
                original.resolve("site.yaml").toString(),
                "--observations",
                "--set",
                "drones.intruder.speed=18 m/s",
                "--seed=9",
                "--out",
                original.resolve("first").toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
    }

    @BeforeEach
    void copyResults() throws IOException {
        Path first = Files.createDirectory(directory.resolve("first"));
        for (String name : List.of("provenance.json", "result.json", "detections.csv", "observations.csv")) {
            Files.copy(original.resolve("first").resolve(name), first.resolve(name));
        }
        Files.copy(original.resolve("first/flights.csv"), first.resolve("flights.csv"));
        provenance = first.resolve("provenance.json");
    }

    private Outcome again(String... more) {
        String[] words = new String[more.length + 2];
        words[0] = "again";
        words[1] = provenance.toString();
        System.arraycopy(more, 0, words, 2, more.length);
        return Program.run(words);
    }

    @Test
    void aRunIsTheSameBytesAgain() throws IOException {
        provenance = original.resolve("first/provenance.json");
        Outcome outcome = again("--out", directory.resolve("second").toString());

        assertThat(outcome.code()).as(outcome.out() + outcome.err()).isZero();
        assertThat(outcome.out())
                .contains("same       result.json", "same       observations.csv", "the results are byte-identical")
                .doesNotContain("different");
        assertThat(Files.readString(directory.resolve("second/result.json")))
                .isEqualTo(Files.readString(original.resolve("first/result.json")));
    }

    /** The pictures are not in the copy, and one of its tables was altered. */
    @Test
    void whatIsNotTheSameIsNamedFileByFile() throws IOException {
        Path table = directory.resolve("first/detections.csv");
        Files.writeString(table, Files.readString(table) + "\n");
        Files.writeString(
                provenance, Files.readString(provenance).replaceFirst("\"version\" : \"", "\"version\" : \"not "));
        Outcome outcome = again();

        assertThat(outcome.code()).isEqualTo(1);
        assertThat(outcome.out())
                .contains(
                        "changed since the recorded run: version",
                        "different  detections.csv",
                        "same       result.json",
                        "new        plots/",
                        "the results differ");
    }

    /** No class is loaded, no file is read as options, and nothing is written elsewhere. */
    @Test
    void aHostileFileStartsNothing() throws IOException {
        refused("[\"run\", \"org.dronewatch.scenes.MultiSensor\"]", "is a class");
        refused("[\"compare\", \"a.yaml\", \"org.dronewatch.scenes.MultiSensor\"]", "is a class");
        refused("[\"compare\", \"a.yaml\", \"--with\", \"scene=org.dronewatch.scenes.MultiSensor\"]", "is a class");
        refused("[\"run\", \"@options\"]", "is not the name of a scene");
        refused(
                "[\"models\", \"--out\", \"elsewhere\"]",
                "only 'run', 'campaign', 'compare', 'route' and 'place' can be repeated");
        refused("[\"run\", \"a.yaml\", \"--evil\"]", "its command cannot be read");
        refused("[]", "records no command");
        refused("\"rm\"", "records no command");
        Files.writeString(provenance, "{\"program\": \"dronewatch\"");
        assertThat(again().err()).contains("is not JSON").hasLineCount(1);
        Files.writeString(provenance, "{}");
        assertThat(again().err())
                .contains("is not a provenance.json written by dronewatch")
                .hasLineCount(1);
    }

    @Test
    void onlyWhatDecidesTheResultsIsRepeated() throws IOException {
        write("[\"run\", \"a.yaml\", \"--rays\", \"b.obj\", \"--out\", \"c\", \"--real-time\", \"0.001\", \"--view\","
                + " \"--verbose\", \"--threads\", \"9\", \"--observations\", \"--set\", \"x=1 m\", \"--set=y=2\"]");
        Replay replay = new Replay(provenance, RecordedCommand.read(provenance));

        assertThat(replay.words(Path.of("new")))
                .containsExactlyInAnyOrder("run", "a.yaml", "--observations", "--set=x=1 m", "--set=y=2", "--out=new");
    }

    private void write(String command) throws IOException {
        Files.writeString(provenance, "{\"program\": \"dronewatch\", \"command\": " + command + "}");
    }

    private void refused(String command, String message) throws IOException {
        write(command);
        Outcome outcome = again();
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err()).contains(message).hasLineCount(1);
    }
}
