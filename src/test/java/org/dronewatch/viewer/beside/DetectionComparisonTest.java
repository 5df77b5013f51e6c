package org.dronewatch.viewer.beside;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.stream.IntStream;
import org.dronewatch.render.Yard;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.run.RecordedRun;
import org.dronewatch.viewer.run.Recording;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** First detections in two runs, in words: gained, lost, earlier, later, the same, or not known yet. */
class DetectionComparisonTest {
    @TempDir
    private Path directory;

    private RecordedRun run(boolean complete, String... settings) {
        SceneRunner runner = new SceneRunner(new Yard(directory)).set("sensors.microphone.enabled", "false");
        for (String setting : settings) {
            runner.set(setting.split("=")[0], setting.split("=")[1]);
        }
        Recording recording = new Recording();
        runner.listener(recording).run();
        recording.finish(complete);
        return recording.runs().get(0);
    }

    private static List<List<Object>> rows(RecordedRun here, RecordedRun there, double time) {
        ComparisonTable table = new ComparisonTable();
        table.show(here, there, time);
        return IntStream.range(0, table.getRowCount())
                .mapToObj(row -> IntStream.range(1, table.getColumnCount())
                        .mapToObj(column -> table.getValueAt(row, column))
                        .toList())
                .toList();
    }

    @Test
    void theSameRunHasNoDifferences() {
        RecordedRun run = run(true);
        assertThat(rows(run, run(true), 6.0))
                .containsExactly(
                        List.of("any", "5.30 s by camera", "5.30 s by camera", "same", "both"),
                        List.of("camera", "5.30 s", "5.30 s", "same", "both"));
    }

    @Test
    void aNarrowerViewDetectsLaterAndAShorterRunNever() {
        RecordedRun wide = run(true);
        RecordedRun narrow = run(true, "sensors.camera.fov=5 deg");
        RecordedRun brief = run(true, "run.duration=2 s");
        assertThat(rows(narrow, wide, 6.0).get(1))
                .containsExactly("camera", "6.10 s", "5.30 s", "0.80 s later", "other");
        assertThat(rows(wide, narrow, 6.0).get(1))
                .containsExactly("camera", "5.30 s", "6.10 s", "0.80 s earlier", "this");
        assertThat(rows(wide, brief, 1.0).get(1)).containsExactly("camera", "5.30 s", "never", "gained", "-");
        assertThat(rows(brief, wide, 1.0).get(1)).containsExactly("camera", "never", "5.30 s", "lost", "-");
        assertThat(rows(brief, brief, 1.0).get(1)).containsExactly("camera", "never", "never", "same", "-");
    }

    @Test
    void whatIsNotSimulatedYetIsNotJudged() {
        RecordedRun begun = run(false, "run.duration=2 s");
        assertThat(rows(run(true), begun, 1.0).get(1)).containsExactly("camera", "5.30 s", "not yet", "", "-");
    }

    @Test
    void aSensorThatIsSwitchedOffIsNotThere() {
        RecordedRun both = run(true, "sensors.microphone.enabled=true");
        List<Object> microphone = rows(run(true), both, 0.5).get(2);
        assertThat(microphone).containsExactly("microphone", "absent", "0.00 s", "other run only", "other");
        assertThat(rows(both, run(true), 0.5).get(2))
                .containsExactly("microphone", "0.00 s", "absent", "this run only", "this");
        assertThat(ChangedSettings.text(both.info().settings(), run(true).info().settings()))
                .isEqualTo("Sensors that differ: 'microphone' on (other run: off).");
    }

    /** Long numbers are shortened as long as they can be told apart. */
    @Test
    void changesAreListedAndCounted() {
        RecordedRun here = run(
                true,
                "run.duration=0.1 s",
                "sensors.camera.fov=0.7 rad",
                "sensors.camera.rate=5 Hz",
                "sensors.camera.height=200",
                "sensors.camera.width=300");
        RecordedRun there = run(true, "run.duration=0.1 s", "sensors.camera.fov=0.700001 rad");
        assertThat(ChangedSettings.text(here.info().settings(), here.info().settings()))
                .isEqualTo("All sensors have the same settings as in the other run.");
        assertThat(ChangedSettings.text(here.info().settings(), there.info().settings()))
                .startsWith("Sensors that differ: 'camera' ")
                .contains("'camera' rate 5 Hz (other run: 10 Hz)")
                .containsPattern("fov 40\\.1070\\d+ deg \\(other run: 40\\.1071\\d+ deg\\)");
    }
}
