package org.dronewatch.scenes;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dronewatch.drone.Drone;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.AcousticSensor;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyReading;
import org.dronewatch.sensor.acoustic.level.LevelReading;
import org.dronewatch.sound.Levels;
import org.junit.jupiter.api.Test;

class ClosedSpaceTest {

    @Test
    void theDroneIsSeenAndHeard() {
        SceneResult result = new ClosedSpace().run();

        assertThat(result.firstDetectionRange("camera", "quadrotor").orElseThrow())
                .isCloseTo(10.0, within(1e-9));
        assertThat(result.firstDetectionRange("microphone", "quadrotor").orElseThrow())
                .isCloseTo(10.0, within(1e-9));
    }

    /** By the energy model: a drone of 85 dB sound power is far above the background, and reverberation adds to it. */
    @Test
    void theEnergyModelHearsItTooWithItsReverberation() {
        SceneRunner runner = new SceneRunner(new ClosedSpace()).set("sensors.microphone.propagation", "energy-model");
        SceneSettings settings = runner.settings();
        Stage stage = runner.stage(settings);
        AcousticSensor sensor = ((AcousticSettings) settings.sensors().get("microphone")).create();
        EnergyReading reading = sensor.read(stage.world(), stage.dronesAt(0.0).get(0), new SplittableRandom(1));

        double direct = 85.0 - Levels.sphericalSpreading(10.0);
        assertThat(reading.aWeightedLevel()).isGreaterThan(direct + 3.0).isLessThan(85.0);
        assertThat(reading.standardError()).isLessThan(0.5);
        assertThat(reading.audit().escaped()).as("the church holds its air").isZero();
        assertThat(reading.audit().imbalance()).isCloseTo(0.0, within(1e-9));
    }

    /** Everything that 20 x 20 rays and three orders can reach; what the order cuts is counted, and always the same. */
    @Test
    void tracingFullyAgreesAndTellsWhatWasCut() {
        List<LevelReading> heard = new ArrayList<>();
        for (int budget : new int[] {200_000, 200_000, 50_000}) {
            SceneRunner runner = new SceneRunner(new ClosedSpace())
                    .set("sensors.microphone.propagation.initialRays", "20")
                    .set("sensors.microphone.propagation.reflectionsPerHit", "20")
                    .set("sensors.microphone.propagation.rayBudget", Integer.toString(budget));
            SceneSettings settings = runner.settings();
            Stage stage = runner.stage(settings);
            Drone drone = stage.dronesAt(0.0).get(0);
            AcousticSensor sensor = ((AcousticSettings) settings.sensors().get("microphone")).create();
            heard.add(sensor.listenFully(stage.world(), drone, new SplittableRandom(1), RayRecorder.NONE));
            assertThat(sensor.listen(stage.world(), drone, new SplittableRandom(1))
                            .detected())
                    .isTrue();
        }
        LevelReading full = heard.get(0);
        assertThat(full.detected()).isTrue();
        assertThat(full.bestLevel()).isCloseTo(55 - 0.05 * 10, within(1e-9));
        assertThat(full.traced()).isBetween(20_000L, 176_841L);
        assertThat(full.cutByOrder()).isPositive();
        assertThat(full.cutByBudget()).isZero();
        assertThat(heard.get(1)).isEqualTo(full);
        assertThat(heard.get(2).traced()).isEqualTo(50_000);
        assertThat(heard.get(2).cutByBudget()).isPositive();
        assertThat(heard.get(2).cutOrder()).hasValue(3);
    }

    /** What order and budget cut is the same whether one thread listens or two do at the same time. */
    @Test
    void theSameIsCutForAnyNumberOfThreads() throws Exception {
        SceneRunner runner = new SceneRunner(new ClosedSpace())
                .set("sensors.microphone.propagation.initialRays", "20")
                .set("sensors.microphone.propagation.reflectionsPerHit", "20")
                .set("sensors.microphone.propagation.rayBudget", "50000");
        SceneSettings settings = runner.settings();
        Stage stage = runner.stage(settings);
        Drone drone = stage.dronesAt(0.0).get(0);
        List<Callable<LevelReading>> looks = new ArrayList<>();
        for (int i = 0; i < 2; i++) {
            AcousticSensor sensor = ((AcousticSettings) settings.sensors().get("microphone")).create();
            looks.add(() -> sensor.listenFully(stage.world(), drone, new SplittableRandom(9), RayRecorder.NONE));
        }
        List<LevelReading> together = results(looks, 2);
        assertThat(together.get(0).cutByOrder()).isPositive();
        assertThat(together.get(0).cutByBudget()).isPositive();
        assertThat(together.get(1)).isEqualTo(together.get(0));
        assertThat(results(looks.subList(0, 1), 1).get(0)).isEqualTo(together.get(0));
    }

    private static List<LevelReading> results(List<Callable<LevelReading>> looks, int threads) throws Exception {
        ExecutorService pool = Executors.newFixedThreadPool(threads);
        try {
            List<LevelReading> results = new ArrayList<>();
            for (Future<LevelReading> look : pool.invokeAll(looks)) {
                results.add(look.get());
            }
            return results;
        } finally {
            pool.shutdownNow();
        }
    }
}
