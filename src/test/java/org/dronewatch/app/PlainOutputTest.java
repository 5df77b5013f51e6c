package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** No name in a file or on the command line steers the terminal or floods it. */
class PlainOutputTest {
    private static final String STEERING = "a\u001b]0;title\u0007\u001b[31m\u009b2J\u202eb\u2028c\u007f";

    @TempDir
    private Path directory;

    private static void assertPlain(String text) {
        assertThat(text)
                .doesNotContainPattern("[\\p{Cntrl}\u0080-\u009f\u202a-\u202e\u2066-\u2069\u2028\u2029&&[^\n\t]]");
    }

    @Test
    void namesInAModelDoNotSteerTheTerminal() {
        Path scene = Program.FUZZ.resolve("escape-characters-in-names/scene.yaml");
        Outcome outcome = Program.run("check", scene.toString());
        assertPlain(outcome.err());
        assertPlain(outcome.out());
        assertThat(outcome.err()).contains("q\\u001b[2J");

        List<String> notes = new ArrayList<>();
        SceneRunner runner = new SceneRunner(new SceneFile(scene)).notes(notes::add);
        runner.stage(runner.settings());
        assertThat(notes).isNotEmpty().allSatisfy(PlainOutputTest::assertPlain);
        assertThat(String.join("\n", notes)).contains("q\\u001b[2J");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "run X",
                "run X.yaml",
                "run camera-range --set X",
                "run camera-range --set X=1",
                "run camera-range --set sensors.camera.fov=X",
                "run camera-range --threads X",
                "run camera-range --X",
                "X",
                "run camera-range --out /dev/null/X",
                "render camera-range --camera X --out DIR/a.png",
                "render camera-range --view X --out DIR/a.png",
                "render camera-range --view top --size X --out DIR/a.png",
                "render camera-range --view top --cut X --out DIR/a.png",
                "render camera-range --view top --focus X --out DIR/a.png",
                "render camera-range --view top --bearing X --out DIR/a.png",
                "render camera-range --camera camera --time X --out DIR/a.png",
                "render camera-range --camera camera --out X",
                "coverage camera-range --side X --out DIR/a.png",
                "coverage camera-range --drone X --out DIR/a.png",
                "bench X",
                "bench packaged:quadrotor.obj --rays X",
                "bench packaged:X",
                "models --out X",
                "costs --drone X --largest 1000 --out DIR/costs",
            })
    void noValueSteersTheTerminalOrFloodsIt(String line) {
        for (String value : List.of(STEERING, "many words ".repeat(900).strip(), "w".repeat(20_000))) {
            Outcome outcome = Program.run(java.util.Arrays.stream(line.split(" "))
                    .map(word -> word.replace("X", value).replace("DIR", directory.toString()))
                    .toArray(String[]::new));
            assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
            assertThat(outcome.out()).isEmpty();
            assertPlain(outcome.err());
            assertThat(outcome.complaints()).hasSize(1);
            String said = outcome.complaints().get(0);
            assertThat(said.split("many words", -1).length - 1).as(said).isLessThanOrEqualTo(36);
            assertThat(said).doesNotContain("w".repeat(201));
        }
    }

    /** A number of the program has the same digits everywhere. */
    @Test
    void tablesDoNotDependOnTheLocale() {
        String english = Program.run("check", "camera-range").out();
        Locale before = Locale.getDefault();
        Locale.setDefault(Locale.forLanguageTag("ar-EG-u-nu-arab"));
        try {
            assertThat(Program.run("check", "camera-range").out()).isEqualTo(english);
            assertThat(Program.run("models", "--out", directory.toString()).out())
                    .containsPattern("[0-9],[0-9]{3} bytes");
        } finally {
            Locale.setDefault(before);
        }
    }
}
