package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.HashMap;
import java.util.Map;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.Wilson;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.drone.RadarSignature;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.camera.TargetTask;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarDetection;
import org.dronewatch.sensor.radar.RadarSettings;
import org.junit.jupiter.api.Test;

/** Hundreds of runs of one scene that differ in their seeds only, against the closed form of what they should give. */
class SeededRunsTest {
    private static final int RUNS = LongForm.count(500, 1000);
    private static final long FIRST_SEED = 42_000;
    private static final double SIGMAS = 3.0;

    /**
     * A radar and a camera that both throw dice, and a drone that hangs before them: four looks each. The radar's looks
     * are independent. The camera's observer can see the drone or not, and has three seconds to find it, from the first
     * look to the fourth.
     */
    private static final class Dice extends FloorScene {
        private static final long serialVersionUID = 1L;

        private final transient AlertSettings alert;

        Dice(AlertSettings alert) {
            this.alert = alert;
        }

        @Override
        protected void build() {
            Position drone = new Position(0, 200, 30);
            Position sensors = new Position(0, 0, 30);
            loadFloor();
            DroneSettings hovering =
                    DroneSettings.of(loadPackaged("quadrotor.obj"), FlightPathSettings.Hover.at(drone));
            RadarSignature fluctuating = hovering.radar().withFluctuation(RadarSignature.Fluctuation.SWERLING_1);
            add("drone", hovering.withRadar(fluctuating));
            add(
                    "radar",
                    RadarSettings.at(sensors, LinkBudget.DataSheet.of(215, 0.01))
                            .withSpeeds(0, 100)
                            .withDetection(RadarDetection.Chance.DEFAULT));
            add(
                    "camera",
                    CameraSettings.at(sensors)
                            .withLookAt(drone)
                            // The middle of a full HD image, a 24th of its width: as many pixels on the drone.
                            .withResolution(80, 45)
                            .withVerticalFov(2.0 * Math.atan(Math.tan(0.5 * 0.6918) / 24.0))
                            .withRate(1.0)
                            .withDetection(TargetTask.DEFAULT.withChance(true)));
            setAlert(alert);
            setRun(RunSettings.DEFAULT.withDuration(3.5));
        }
    }

    private record Outcome(int alerts, Map<String, Double> probabilities) {}

    /** How many of the runs had an alert, and how likely each sensor said that a look was to detect. */
    private Outcome runs(AlertSettings settings) {
        System.out.println("seeds " + FIRST_SEED + " to " + (FIRST_SEED + RUNS - 1));
        Map<String, Double> probabilities = new HashMap<>();
        SceneRunner runner = new SceneRunner(new Dice(settings)).threads(1).onFrame(frame -> frame.observations()
                .forEach(look -> probabilities.merge(look.sensor(), look.probability(), (old, now) -> {
                    assertThat(now).isEqualTo(old);
                    return old;
                })));
        int alerts = 0;
        for (int run = 0; run < RUNS; run++) {
            SceneResult result = runner.seed(FIRST_SEED + run).run();
            alerts += result.alert("drone").time().isPresent() ? 1 : 0;
        }
        return new Outcome(alerts, probabilities);
    }

    private static void assertAgrees(int alerts, double expected) {
        double[] interval = Wilson.interval(alerts, RUNS, SIGMAS);
        System.out.printf("%d of %d, expected %.4f%n", alerts, RUNS, expected);
        assertThat(expected).isBetween(interval[0], interval[1]);
        assertThat(interval[1] - interval[0]).as("the interval tells something").isLessThan(0.1);
    }

    /** {@code x^E / (1 + x^E)} with {@code E = 2.7 + 0.7 x}, and {@code Pfa^(1/(1+S))}. */
    private static void assertClosedForms(Map<String, Double> probabilities, double pixels, double signalToNoise) {
        double seen = 0.5 * Math.pow(0.05, 200.0 / 20_000.0);
        double x = 0.5 * Math.sqrt(pixels) * (1.0 - 0.02 / seen) / 0.75;
        double odds = Math.pow(x, 2.7 + 0.7 * x);
        assertThat(probabilities.get("camera")).isCloseTo(odds / (1.0 + odds), within(1e-9));
        double radar = Math.pow(1e-6, 1.0 / (1.0 + Math.pow(10.0, 0.1 * signalToNoise)));
        assertThat(probabilities.get("radar")).isCloseTo(radar, within(1e-9));
    }

    @Test
    void alertsAreAsFrequentAsLooksAreLikely() {
        Observation[] last = new Observation[2];
        new SceneRunner(new Dice(AlertSettings.DEFAULT))
                .onFrame(
                        frame -> frame.observations().forEach(o -> last[o.kind().equals("radar") ? 0 : 1] = o))
                .run();
        Outcome outcome = runs(AlertSettings.DEFAULT);
        double radar = outcome.probabilities().get("radar");
        double camera = outcome.probabilities().get("camera");
        int pixels = cameraPixels();
        assertClosedForms(outcome.probabilities(), pixels, last[0].value());
        assertAgrees(outcome.alerts(), 1.0 - Math.pow(1.0 - radar, 4) * (1.0 - found(camera, 3)));
    }

    /** The probability that an observer has found the drone after some seconds. */
    private static double found(double probability, double seconds) {
        return probability * (1.0 - Math.exp(-probability * seconds / 3.4));
    }

    private int cameraPixels() {
        Dice scene = new Dice(AlertSettings.DEFAULT);
        SceneSettings settings = scene.describe();
        Stage stage = new SceneRunner(scene).stage(settings);
        CameraSettings camera = (CameraSettings) settings.sensors().get("camera");
        return camera.create().pixels(stage.world(), stage.dronesAt(0.0).get(0));
    }

    @Thorough
    @Test
    void confirmedAlertsFollowTheBinomialAndTheSearch() {
        Outcome outcome = runs(AlertSettings.DEFAULT.withConfirmation(2, 4));
        double p = outcome.probabilities().get("radar");
        double q = 1.0 - p;
        double missed = Math.pow(q, 4) + 4.0 * p * Math.pow(q, 3);
        // What is found is held: found by the third look, it is seen in the fourth, too.
        assertAgrees(
                outcome.alerts(),
                1.0 - missed * (1.0 - found(outcome.probabilities().get("camera"), 2)));
    }

    @Thorough
    @Test
    void twoSensorsInAgreementAreRarer() {
        AlertSettings both = AlertSettings.DEFAULT.withRule(new AlertRule.SeveralSensors(2, 0.0));
        Outcome outcome = runs(both);
        double radar = outcome.probabilities().get("radar");
        double camera = outcome.probabilities().get("camera");
        double expected = 0.0;
        for (int look = 1; look <= 3; look++) {
            // Found in this look, it is held in this one and the rest.
            double foundNow = found(camera, look) - found(camera, look - 1);
            expected += foundNow * (1.0 - Math.pow(1.0 - radar, 4 - look));
        }
        assertAgrees(outcome.alerts(), expected);
    }
}
