package org.dronewatch.run;

import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.file.Path;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** A test of detection ranges with a misspelt name must not pass for ever, and must say which names there are. */
class SceneResultTest {
    private static SceneResult result;

    @BeforeAll
    static void oneRun() {
        result = new SceneRunner(new SceneFile(Path.of("scenes", "hill-radar.yaml")))
                .until(1.0)
                .run();
    }

    @Test
    void aMisspeltNameIsRefusedWithTheNamesThatThereAre() {
        RunResult run = result.runs().get(0);
        String sensor = "no sensor 'radr'; the scene has radar";

        assertRefused(() -> run.firstDetectionRange("radr"), sensor);
        assertRefused(() -> run.firstDetection("radr"), sensor);
        assertRefused(() -> result.firstDetectionRange("radr", "quadrotor"), "no sensor 'radr'; the run has radar");
        assertRefused(
                () -> result.firstDetectionRange("radar", "quadrotr"), "no drone 'quadrotr'; the run has quadrotor");
        assertRefused(() -> result.alert("quadrotr"), "no drone 'quadrotr'; the first run has quadrotor");
        assertRefused(() -> result.firstDetectionRange(3, "radar", "quadrotor"), "no run 3, only run 0");
    }

    private static void assertRefused(ThrowingCallable question, String reason) {
        assertThatIllegalArgumentException().isThrownBy(question).withMessageContaining(reason);
    }
}
