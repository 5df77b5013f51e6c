package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.run.SceneResult;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The radar on the hill among the echoes of the ground: the table of the docs, row by row. */
class RadarClutterSceneTest {
    private static final String GROUND = "sensors.radar.clutter.ground.cover";

    private final List<Observation> seen = new ArrayList<>();

    private SceneResult run(String setting, String value) {
        SceneRunner runner = new SceneRunner(new SceneFile(Path.of("scenes", "radar-clutter.yaml")));
        runner.set(setting, value);
        return runner.onFrame(frame -> seen.addAll(frame.observations())).run();
    }

    /** The look at the drone that comes that is nearest to 400 m. */
    private Observation at400() {
        return seen.stream()
                .filter(one -> one.drone().equals("coming") && one.range() < 400.5)
                .findFirst()
                .orElseThrow();
    }

    @ParameterizedTest
    @CsvSource({
        "sensors.radar.clutter.improvement, 150, 15.1, , 15.1, 335",
        GROUND + ", flatland, 15.1, -13.5, 14.9, 328",
        GROUND + ", farmland, 15.1, -8.5, 14.5, 317",
        "world.rain, 25, 14.5, -2.2, 12.4, 271",
        GROUND + ", metropolitan, 15.1, 6.5, 7.7, 271"
    })
    void theTableOfTheDocsIsWhatTheSceneGives(
            String setting, String value, double signal, Double clutter, double both, long first) throws Exception {
        SceneResult result = run(setting, value);
        Observation look = at400();
        double toNoise = look.figures().get("clutter_to_noise_db");
        assertThat(toNoise + look.figures().get("signal_to_clutter_db")).isCloseTo(signal, within(0.05));
        assertThat(look.value()).isCloseTo(both, within(0.05));
        if (clutter != null) {
            assertThat(toNoise).isCloseTo(clutter, within(0.05));
        }
        assertThat(Math.round(result.firstDetectionRange("radar", "coming").orElseThrow()))
                .isEqualTo(first);
        String row = String.format(
                Locale.ROOT,
                "%.1f dB | %s | %.1f dB | %d m |",
                signal,
                clutter == null ? "" : clutter + " dB",
                both,
                first);
        assertThat(Files.readString(Path.of("src", "site", "markdown", "radar.md")))
                .contains(row.replace("|  |", "| |"));
    }

    /** Circling round the radar the drone has no radial speed, hovering it shows its rotors. */
    @Test
    void theCirclingDroneIsLostAndTheHoveringOneIsSeen() {
        SceneResult result = run(GROUND, "farmland");
        assertThat(result.firstDetectionRange("radar", "circling")).isEmpty();
        assertThat(result.firstDetectionRange("radar", "hovering").orElseThrow())
                .isCloseTo(73, within(0.5));
        assertThat(run("drones.hovering.radar.rotorLevel", "40").firstDetectionRange("radar", "hovering"))
                .isEmpty();
    }
}
