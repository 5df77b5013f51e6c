package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.OptionalDouble;
import org.dronewatch.Thorough;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * At what range the cued camera identifies the drone through turbulent air and a small lens: the figures that the
 * page of packaged scenes states.
 * From one frame to the next the drone comes half a metre nearer, which is what the small lens costs: the figures are
 * those of runs, to a hundredth of a metre.
 */
class LongLensRunsTest {
    private static final double TOLERANCE = 0.006;

    private static OptionalDouble identified(double cn2, String aperture) {
        SceneRunner runner = new SceneRunner(new SceneFile(Path.of("scenes/cued-camera.yaml")))
                .threads(2)
                .set("world.light.cn2", Double.toString(cn2));
        return (aperture.equals("none") ? runner : runner.set("sensors.cued.aperture", aperture))
                .run()
                .firstDetectionRange("cued", "intruder");
    }

    @Thorough
    @ParameterizedTest
    @CsvSource({
        "0, none, 722.69",
        "1e-14, none, 722.69",
        "1e-13, none, 721.25",
        "1e-13, 27 mm, 720.77",
        "1e-12, none, 380.83"
    })
    void turbulenceDelaysIdentification(double cn2, String aperture, double range) {
        assertThat(identified(cn2, aperture).orElseThrow()).isCloseTo(range, within(TOLERANCE));
    }
}
