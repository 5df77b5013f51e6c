package org.dronewatch.scenario.advice;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.MultiSensor;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.setting.SettingsPath;
import org.junit.jupiter.api.Test;

class AngleAdviceTest {
    private static final CameraSettings CAMERA = CameraSettings.at(new Position(0, 0, 5));

    private static List<String> lines(Object settings) {
        List<String> lines = new ArrayList<>();
        new AngleAdvice("sensors.gate", (Record) settings).giveTo(lines::add);
        return lines;
    }

    @Test
    void aWholeNumberOfRadiansWasProbablyMeantInDegrees() {
        assertThat(lines(new SettingsPath("aim.azimuth").write(CAMERA, "5")))
                .containsExactly("sensors.gate.aim.azimuth is 286.4789 deg (5 rad); for degrees, write 5 deg");
        assertThat(lines(new SettingsPath("fov").write(CAMERA, "1")))
                .containsExactly("sensors.gate.fov is 57.29578 deg (1 rad); for degrees, write 1 deg");
    }

    @Test
    void whatIsWrittenInDegreesIsNotNamed() {
        assertThat(lines(CAMERA)).isEmpty();
        assertThat(lines(new SettingsPath("aim.azimuth").write(CAMERA, "5 deg")))
                .isEmpty();
        assertThat(lines(new SettingsPath("aim.azimuth").write(CAMERA, "0"))).isEmpty();
        assertThat(lines(new SettingsPath("fov").write(CAMERA, "0.7"))).isEmpty();
        new SceneRunner(new MultiSensor()).settings().sensors().values().forEach(sensor -> assertThat(lines(sensor))
                .isEmpty());
    }
}
