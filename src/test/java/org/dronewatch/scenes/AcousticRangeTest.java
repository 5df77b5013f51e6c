package org.dronewatch.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class AcousticRangeTest {
    private static final double STEP = 0.5;

    @Test
    void theRangesAreAStraightLine() {
        SceneResult result = new AcousticRange().run();

        double[] ranges = {100, 200, 300, 400, 500};
        for (int run = 0; run < ranges.length; run++) {
            assertThat(result.firstDetectionRange(run, "microphone", "quadrotor")
                            .orElseThrow())
                    .isCloseTo(ranges[run], within(STEP));
        }
    }

    /**
     * Physical ranges: where spreading and air alone bring the drone to the level of detection, and a little beyond.
     */
    @Thorough
    @Test
    void theEnergyModelHearsItALittleBeyondTheRangeInTheOpen() {
        SceneResult result = new SceneRunner(new AcousticRange())
                .set("sensors.microphone.propagation", "energy-model")
                .set("world.backgroundNoise", "20")
                // Beyond, the drone is 10 dB too quiet.
                .set("drones.quadrotor.flight.from.y", "250 m")
                .set("run.duration", "38")
                .run();
        double range = result.firstDetectionRange("microphone", "quadrotor").orElseThrow();

        List<Double> power =
                new AcousticRange().describe().drones().get("quadrotor").soundPower();
        double open = 1.0;
        while (levelInTheOpen(power, open) > 20 + 15) {
            open += 0.1;
        }
        assertThat(range).isBetween(open - STEP, 1.1 * open);
        assertThat(range).as("as the page of packaged scenes says").isCloseTo(80, within(1.0));
    }

    private static double levelInTheOpen(List<Double> power, double range) {
        double energy = 0.0;
        for (int band = 0; band < power.size(); band++) {
            double air = range * Atmosphere.STANDARD.attenuation(OctaveBands.midband(band));
            energy += Levels.toRatio(
                    power.get(band) + OctaveBands.aWeight(band) - Levels.sphericalSpreading(range) - air);
        }
        return Levels.ofRatio(energy);
    }

    @Test
    void theSameSeedGivesTheSameForAnyNumberOfThreads() {
        assertThat(observations(2)).isEqualTo(observations(1)).isNotEmpty();
    }

    private static List<Observation> observations(int threads) {
        List<Observation> all = new ArrayList<>();
        new SceneRunner(new AcousticRange())
                .set("world.backgroundNoise", "10")
                .set("drones.quadrotor.soundLevel", "60")
                .set("run.duration", "5")
                .threads(threads)
                .onFrame(frame -> all.addAll(frame.observations()))
                .run();
        assertThat(all).allSatisfy(o -> assertThat(o.figures()).containsKeys("rays_traced", "cut_by_order"));
        return all;
    }

    @Test
    void itsSurfacesAreNamed() {
        List<String> notes = new ArrayList<>();
        new SceneRunner(new AcousticRange())
                .notes(notes::add)
                .set("run.duration", "1")
                .run();
        assertThat(notes).noneMatch(note -> note.contains("warning"));

        new SceneRunner(new AcousticRange())
                .notes(notes::add)
                .set("run.duration", "1")
                .set("world.models.0.file", "packaged:house.obj")
                .run();
        assertThat(notes)
                .filteredOn(note -> note.contains("warning"))
                .satisfiesExactly(
                        note -> assertThat(note).contains("plaster", "wood", "'solid'"),
                        note -> assertThat(note).contains("no material named grass or dry_meadow or forest_floor"));
    }

    @Test
    void aNoiseSourceUnderTheGroundIsWarnedOf(@TempDir Path directory) throws IOException {
        Path file = directory.resolve("buried.yaml");
        Files.writeString(
                file,
                """
                world:
                  models: [packaged:hill.obj]
                  surfaces: {materials: {default: grass_turf}}
                  noiseSources: {pump: {positions: [[0, 0, 125]], soundPowerLevel: 90, soundLevel: 90}}
                sensors:
                  microphone: {kind: acoustic, position: [0, 0, 144]}
                run: {duration: 0.1}
                """);
        List<String> notes = new ArrayList<>();

        new SceneRunner(new SceneFile(file)).notes(notes::add).run();

        assertThat(notes)
                .filteredOn(note -> note.startsWith("warning: world.noiseSources"))
                .singleElement()
                .asString()
                .contains("pump at (0.000, 0.000, 125.000) m", "inside a wall or under the ground");
    }

    @Test
    void aMicrophoneUnderTheGroundIsWarnedOf() {
        List<String> notes = new ArrayList<>();
        new SceneRunner(new AcousticRange())
                .notes(notes::add)
                .set("run.duration", "0.1")
                .set("sensors.microphone.position", "0, 0, 125 m")
                .run();
        assertThat(notes)
                .filteredOn(note -> note.startsWith("warning"))
                .singleElement()
                .asString()
                .contains("'microphone' at (0.000, 0.000, 125.000) m", "inside a wall or under the ground");
    }
}
