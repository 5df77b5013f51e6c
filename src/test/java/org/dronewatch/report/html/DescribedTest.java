package org.dronewatch.report.html;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Set;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.acoustic.level.Listening;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.optics.Projection;
import org.dronewatch.sensor.thermal.ThermalSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class DescribedTest {
    private static final CameraSettings CAMERA = CameraSettings.at(new Position(1, 2, 3));
    private static final AcousticSettings MICROPHONE = AcousticSettings.at(new Position(1, 2, 3));

    private static String of(Record settings) {
        return Described.of(settings, Set.of("position", "rate"));
    }

    @Test
    void minorSettingsAtTheirDefaultsAreLeftOut() {
        assertThat(of(CAMERA))
                .isEqualTo(
                        "aim direction (azimuth 0\u00b0, elevation 0\u00b0), width 1920 px, height 1080 px, fov 39.64\u00b0,"
                                + " fov axis vertical, detection pixel-threshold (pixels 12 px)");
        assertThat(of(ThermalSettings.at(new Position(1, 2, 3)))).doesNotContain("roll", "projection");
        assertThat(of(MICROPHONE))
                .isEqualTo("radius 0.5 m, threshold 15 dB, array gain 0 dB, propagation level-model (initial rays 10,"
                        + " reflections per hit 10, attenuation 0.05 dB/m, max order 3, ray budget 200000)");
    }

    /** A field of cameras turned step by step may go on beyond a whole turn; an elevation is not a bearing. */
    @ParameterizedTest
    @CsvSource({"375, 15", "-15, 345", "360, 0", "-360, 0", "90, 90", "720, 0"})
    void bearingsAreThoseOfACompass(double set, String shown) {
        assertThat(Described.of(new Aim.Direction(Math.toRadians(set), Math.toRadians(-5)), Set.of()))
                .isEqualTo("azimuth " + shown + "\u00b0, elevation -5\u00b0");
    }

    @Test
    void minorSettingsThatDifferAreListed() {
        assertThat(of(CAMERA.withRoll(Math.toRadians(30)).withProjection(Projection.shifted(0, 0.2))))
                .contains(", roll 30\u00b0, ", ", projection (shift up 0.2), ");
        assertThat(of(CAMERA.withProjection(new Projection(0, 0, 0.5, 300))))
                .contains(", projection (near 0.5 m, far 300 m), ");
        assertThat(of(MICROPHONE
                        .withDrawRays(true)
                        .withPropagation(LevelModel.DEFAULT
                                .withListening(Listening.THOROUGH)
                                .withTransmittedRays(4))))
                .endsWith("ray budget 200000, listening thorough, transmitted rays 4), draw rays true");
    }
}
