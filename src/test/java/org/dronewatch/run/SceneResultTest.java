package org.dronewatch.run;

import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.nio.file.Path;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.CameraRange;
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

        assertRefused(() -> run.firstDetectionRange("radr"), "no sensor 'radr'; the scene has radar");
        assertRefused(() -> run.firstDetection("radr"), "no sensor 'radr'; the scene has radar");
        assertRefused(() -> result.firstDetectionRange("radr", "quadrotor"), "no sensor 'radr'; the run has radar");
        assertRefused(
                () -> result.firstDetectionRange("radar", "quadrotr"), "no drone 'quadrotr'; the run has quadrotor");
        assertRefused(() -> result.alert("quadrotr"), "no drone 'quadrotr'; the run has quadrotor");
        assertRefused(() -> result.firstDetectionRange(3, "radar", "quadrotor"), "no run '3'; the result has 0");
    }

    /** One run of a sweep has its number in the sweep. */
    @Test
    void aRunThatWasNotRunIsRefused() {
        SceneResult third =
                new SceneRunner(new CameraRange()).only(2).until(1.0).run();

        assertRefused(() -> third.alert("quadrotor"), "no run '0'; the result has 2");
        assertRefused(() -> third.firstDetectionRange("camera", "quadrotor"), "no run '0'; the result has 2");
    }

    @Test
    void aSensorThatIsSwitchedOffIsNotOneThatDetectsNothing() {
        SceneRunner runner = new SceneRunner(new SceneFile(Path.of("scenes", "hill-radar.yaml")));
        SceneResult off =
                runner.set("sensors.radar.enabled", "false").until(1.0).run();

        assertRefused(() -> off.runs().get(0).firstDetectionRange("radar"), "sensor 'radar' is switched off");
        assertRefused(() -> off.firstDetectionRange("radar", "quadrotor"), "no sensor 'radar'; the run has no sensors");
    }

    private static void assertRefused(ThrowingCallable question, String reason) {
        assertThatIllegalArgumentException().isThrownBy(question).withMessageContaining(reason);
    }
}
