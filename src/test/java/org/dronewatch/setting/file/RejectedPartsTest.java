package org.dronewatch.setting.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Settings that contradict each other: each mistake is reported once, at what is wrong, and nothing that is right. */
class RejectedPartsTest {
    private static final String CLUTTER =
            "clutter: {ground: {kind: land-cover, cover: woods}, improvement: 40 dB, bandwidth: 10 MHz}";

    @TempDir
    private Path directory;

    /** What is said of a radar with a beam of a data-sheet budget, line by line, without the name of the file. */
    private List<String> problems(String... settings) throws IOException {
        Path file = directory.resolve("site.yaml");
        Files.writeString(
                file,
                """
                world: {models: [packaged:hill.obj]}
                sensors:
                  radar:
                    kind: radar
                    position: [0, 0, 150]
                    budget: {kind: data-sheet, range: 900, crossSection: 0.01}
                """
                        + "    " + String.join("\n    ", settings) + "\n");
        InputException said = catchThrowableOfType(InputException.class, () -> new SceneFile(file).describe());
        return said == null
                ? List.of()
                : said.getMessage()
                        .lines()
                        .map(line -> line.replaceFirst("^.*site.yaml:", ""))
                        .toList();
    }

    @Test
    void aPartMayNeedAnother() throws IOException {
        String beam = "beam: {azimuthBeamwidth: 4 deg, elevationBeamwidth: 20 deg}";
        assertThat(problems(beam, CLUTTER)).isEmpty();
        assertThat(problems(CLUTTER, beam)).isEmpty();
        assertThat(problems(CLUTTER))
                .containsExactly("7:14: sensors.radar.clutter: clutter needs a beam, whose azimuthBeamwidth is the"
                        + " width of a resolution cell");
    }

    /** Beside another mistake, what has all that it needs is no mistake; what has not, is. */
    @Test
    void beforeAnotherMistakeOnlyWhatIsWrongIsReported() throws IOException {
        String beam = "beam: {azimuthBeamwidth: 4 deg, elevationBeamwidth: 20 deg}";
        String far = "minRange: 30 km";
        assertThat(problems(beam, CLUTTER, far))
                .containsExactly("9:15: sensors.radar.minRange: minRange 30000.0 m must be below maxRange 10000.0 m");
        assertThat(problems(CLUTTER, far)).hasSize(2);
        assertThat(problems(beam, CLUTTER.replace(", bandwidth: 10 MHz", ""), far))
                .containsExactly("9:15: sensors.radar.minRange: minRange 30000.0 m must be below maxRange 10000.0 m");
        assertThat(problems(beam, CLUTTER.replace(", bandwidth: 10 MHz", "")))
                .containsExactly("8:14: sensors.radar: clutter needs a bandwidth: the budget states none");
    }

    /** What is needed stands there but cannot be read: that is said, and no more. */
    @Test
    void whatCannotBeReadIsNotMissedAgain() throws IOException {
        assertThat(problems("beam: {azimuthBeamwidth: 4 deg, elevationBeamwidth: 400 deg}", CLUTTER))
                .hasSize(1)
                .allSatisfy(line -> assertThat(line).contains("beam.elevationBeamwidth"));
    }
}
