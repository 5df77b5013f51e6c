package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.campaign.CampaignSite;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Results are repeated from their provenance, which is data that anybody may have written. */
class AgainCommandTest {
    @TempDir
    private Path directory;

    private Path scene;
    private Path provenance;

    @BeforeEach
    void run() throws IOException {
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
        scene = directory.resolve("site.yaml");
        Outcome outcome = Program.run(
                "run",
                scene.toString(),
                "--observations",
                "--set",
                "drones.intruder.speed=18 m/s",
                "--seed=9",
                "--out",
                directory.resolve("first").toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        provenance = directory.resolve("first/provenance.json");
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
        Outcome outcome = again("--out", directory.resolve("second").toString());

        assertThat(outcome.code()).as(outcome.out() + outcome.err()).isZero();
        assertThat(outcome.out())
                .contains("same       result.json", "same       observations.csv", "the results have the same bytes")
                .doesNotContain("different");
        assertThat(Files.readString(directory.resolve("second/result.json")))
                .isEqualTo(Files.readString(directory.resolve("first/result.json")));
    }

    @Test
    void whatHasChangedIsNamedFileByFile() throws IOException {
        Files.writeString(scene, Files.readString(scene).replace("height: 40 m", "height: 60 m"));
        Outcome outcome = again();

        assertThat(outcome.code()).isEqualTo(1);
        assertThat(outcome.out())
                .contains("not the same as then: scene", "different  result.json", "the results are not the same");
    }

    @Test
    void aFileThatWasAlteredAfterwardsIsFound() throws IOException {
        Path table = directory.resolve("first/detections.csv");
        Files.writeString(table, Files.readString(table) + "\n");
        Outcome outcome = again();

        assertThat(outcome.code()).isEqualTo(1);
        assertThat(outcome.out()).contains("different  detections.csv", "same       result.json");
    }

    /** No class is loaded, no file is read as options, and nothing is written elsewhere. */
    @Test
    void aHostileFileStartsNothing() throws IOException {
        refused("[\"run\", \"org.dronewatch.scenes.MultiSensor\"]", "is a class");
        refused("[\"run\", \"@options\"]", "is not the name of a scene");
        refused("[\"models\", \"--out\", \"elsewhere\"]", "only 'run' and 'campaign' can be repeated");
        refused("[\"run\", \"a.yaml\", \"--evil\"]", "its command cannot be read");
        refused("[]", "states no command");
        refused("\"rm\"", "states no command");
        Path rays = directory.resolve("rays.obj");
        Path elsewhere = directory.resolve("elsewhere");
        write("[\"run\", \"" + scene + "\", \"--rays\", \"" + rays + "\", \"--out\", \"" + elsewhere
                + "\", \"--real-time\", \"0.001\"]");
        assertThat(again().code()).isEqualTo(1);
        assertThat(rays).doesNotExist();
        assertThat(elsewhere).doesNotExist();
        Files.writeString(provenance, "{\"program\": \"dronewatch\"");
        assertThat(again().err()).contains("is not JSON").hasLineCount(1);
        Files.writeString(provenance, "{}");
        assertThat(again().err()).contains("is no provenance.json").hasLineCount(1);
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
