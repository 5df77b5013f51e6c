package org.dronewatch.scenario.advice;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.sound.DroneSounds;
import org.junit.jupiter.api.Test;

class SoundAdviceTest {
    private static final DroneSettings QUADROTOR =
            DroneSettings.of(ModelSettings.of("quadrotor.obj"), new Hover(new Position(0, 0, 10), 0.0));

    @Test
    void aMeasuredSoundMissesItsDirectivityAndItsLoudness() {
        assertThat(advice(named("m300")))
                .containsExactly(
                        "drone 'intruder' has the sound of m300 but radiates it equally in all directions: the measured drone"
                                + " has 'directivity: m300'",
                        "drone 'intruder' has the sound of m300 at 85.0 dB: the measured drone had 92.6 dB");
        assertThat(advice(SettingsForm.with(named("m300"), "soundPowerLevel", 90.0)))
                .singleElement()
                .asString()
                .contains("directivity");
    }

    @Test
    void nothingIsSaidOfWholeOrAssumedSounds() {
        assertThat(advice(QUADROTOR)).isEmpty();
        assertThat(advice(QUADROTOR.withSound(DroneSounds.get("m300")))).isEmpty();
    }

    private static DroneSettings named(String sound) {
        return SettingsForm.with(QUADROTOR, "sound", sound);
    }

    private static List<String> advice(DroneSettings drone) {
        List<String> lines = new ArrayList<>();
        new SoundAdvice("intruder", drone).giveTo(lines::add);
        return lines;
    }
}
