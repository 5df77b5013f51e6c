package org.dronewatch.docs;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.CameraRange;
import org.dronewatch.sensor.Observation;
import org.junit.jupiter.api.Test;

/**
 * By which range how many observers have found the drone of {@code camera-range}, as the page about cameras states it:
 * the same at 10, 25 and 50 frames a second. No draw decides: P of every frame gives the rate at which each of two
 * thousand observers finds the drone.
 */
class ObserverRangesTest {
    private static final Path PAGE = Path.of("src/site/markdown/camera.md");

    /**
     * Of the field of 1 rad and its 1920 x 1080 pixels only the middle is drawn: the same rays on the drone. The flight
     * is that part of the scene's in which it can be found, P above 0, until nine in ten have.
     */
    private static List<Observation> looks(int rate) {
        double fov = 2.0 * Math.atan(160.0 / 960.0 * Math.tan(0.5));
        SceneRunner runner = new SceneRunner(new CameraRange());
        Map.of("fov", Double.toString(fov), "width", "320", "height", "180", "rate", Integer.toString(rate))
                .forEach((setting, value) -> runner.set("sensors.camera." + setting, value));
        runner.set("drones.quadrotor.flight.from.y", "160").set("run.duration", "20.5");
        runner.set("sensors.camera.detection", "target-task").set("sensors.camera.detection.byChance", "true");
        List<Observation> looks = new ArrayList<>();
        runner.onFrame(frame -> looks.addAll(frame.observations())).run();
        return looks;
    }

    private static double[] ranges(int rate, double... shares) {
        List<Observation> looks = looks(rate);
        double[] detected = FirstDetections.observers(looks);
        return Arrays.stream(shares)
                .map(share -> FirstDetections.quantile(looks, detected, share).orElseThrow())
                .toArray();
    }

    @Test
    void rangesDoNotDependOnTheFrameRate() throws IOException {
        String page = Files.readString(PAGE).replaceAll("\\s+", " ");
        double[] tenth = new double[3];
        double[] half = new double[3];
        double[] nine = new double[3];
        int[] rates = {10, 25, 50};
        for (int i = 0; i < rates.length; i++) {
            double[] all = ranges(rates[i], 0.1, 0.5, 0.9);
            tenth[i] = all[0];
            half[i] = all[1];
            nine[i] = all[2];
        }
        // A frame at 10 Hz is half a metre long, and which pixels thin arms meet differs from frame to frame.
        for (int i = 1; i < rates.length; i++) {
            assertThat(half[i]).isCloseTo(half[0], within(0.6));
            assertThat(tenth[i]).isCloseTo(tenth[0], within(0.6));
            assertThat(nine[i]).isCloseTo(nine[0], within(0.6));
        }
        assertThat(page)
                .contains(String.format(
                        Locale.ROOT,
                        "10 %% of observers find the drone at %.0f m or more, 50 %% at %.0f m or more,"
                                + " 90 %% at %.0f m or more",
                        tenth[1],
                        half[1],
                        nine[1]))
                .contains(String.format(
                        Locale.ROOT,
                        "by the time it is %.1f m away at 10 frames a second, %.1f m at 25, and %.1f m at 50",
                        half[0],
                        half[1],
                        half[2]));
    }
}
