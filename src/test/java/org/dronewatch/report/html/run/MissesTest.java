package org.dronewatch.report.html.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.report.html.ReportPage.parsed;
import static org.dronewatch.report.html.ReportPage.texts;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.FalseAlarmResult;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.RunResult;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.GroundTruth;
import org.dronewatch.sensor.LookId;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Document;

/** What the report says of sensors that detect a drone for part of a minute, at times that the tests choose. */
class MissesTest {
    private static final String RADIO = "{kind: rf, position: [0, 0, 150]}";

    @TempDir
    private Path directory;

    private SceneRunner runner;
    private RunLooks looks;
    private final List<DetectionEvent> events = new ArrayList<>();

    @BeforeEach
    void oneReceiver() throws IOException {
        scene("1", "  radio: " + RADIO);
    }

    private void scene(String swarm, String sensors) throws IOException {
        Path file = Files.writeString(
                directory.resolve("scene.yaml"),
                """
                world: {models: [packaged:hill.obj]}
                drones:
                  x:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [0, 50, 170]}
                    swarm: %s
                sensors:
                %s
                run: {duration: 60 s}
                """
                        .formatted(swarm, sensors));
        runner = new SceneRunner(new SceneFile(file));
        looks = new RunLooks(60.0, runner.stage(runner.settings()));
    }

    private void event(String sensor, String drone, boolean gained, double time) {
        events.add(new DetectionEvent(
                0,
                gained,
                new Observation(
                        new LookId(sensor, "rf", 0, time),
                        new GroundTruth(drone, 50, time),
                        new Reading(gained ? 9 : 1, 5, "dB"),
                        Map.of(),
                        Optional.empty())));
    }

    private Document tables() throws IOException {
        SceneSettings settings = runner.settings();
        List<PairResult> pairs = new ArrayList<>();
        for (String sensor : settings.enabledSensors().keySet()) {
            for (String drone : settings.individualDrones().keySet()) {
                OptionalDouble first = events.stream()
                        .map(DetectionEvent::observation)
                        .filter(one ->
                                one.sensor().equals(sensor) && one.drone().equals(drone))
                        .mapToDouble(Observation::arrival)
                        .min();
                pairs.add(new PairResult(0, sensor, "rf", drone, first, first, false, first));
            }
        }
        return tables(pairs);
    }

    private Document tables(List<PairResult> pairs) throws IOException {
        SceneSettings settings = runner.settings();
        FalseAlarmResult none = new FalseAlarmResult(Map.of(), Map.of(), 0, List.of(), Map.of(), List.of());
        RunResult run = new RunResult(0, settings, 60.0, events, pairs, List.of(), none);
        Reasons reasons = new Reasons(settings, looks.stage(), looks.pointings(), 60.0);
        return parsed("<r>" + new Misses(run, looks, reasons).tables() + "</r>");
    }

    /** Between two of the moments at which reasons are determined. */
    @Test
    void aDroneThatIsDetectedForAMomentIsNotMissedAllTheTime() throws IOException {
        event("radio", "x-1", true, 20.03);
        event("radio", "x-1", false, 20.06);

        assertThat(texts(tables(), "td")).contains("more than 99 %").doesNotContain("100 %");
    }

    /** A signal that a look would detect is not too weak. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "before the first look at the drone| false | fixed",
                "between looks     | true  | fixed",
                "missed by chance or between looks| true  | chance",
            })
    void whatCouldBeDetectedIsNotTooWeak(String reason, boolean looked, String detection) throws IOException {
        if (detection.equals("chance")) {
            scene(
                    "1",
                    "  radio: {kind: radar, position: [0, 0, 150], minRange: 1, maxRange: 400, elevationWidth: 90 deg,"
                            + " minSpeed: 0 m/s, budget: {range: 50, crossSection: 0.01}, detection: {kind: chance}}");
        }
        if (looked) {
            runner.onFrame(looks::add).run();
        }
        event("radio", "x-1", true, 45.0);

        assertThat(texts(tables(), "td")).containsSubsequence("75 %", reason);
    }

    /** The fifth of 25 drones is not one of those for which reasons are determined if all are missed. */
    @Test
    void aSingleDroneOfASwarmHasARow() throws IOException {
        scene("25", "  radio: " + RADIO);
        for (int i = 1; i <= 25; i++) {
            event("radio", "x-" + i, true, i == 5 ? 11.4 : 0.0);
        }

        assertThat(texts(tables(), "td")).contains("x: 1 of 25 drones", "19 %");
        assertThat(texts(tables(), "p"))
                .contains(
                        "Every sensor detects every drone at some time. The table below states for what part of the run"
                                + " a sensor does not detect a drone, and why.");
    }

    @Test
    void partsOfASwarmAreARange() throws IOException {
        scene("2", "  radio: " + RADIO);
        event("radio", "x-1", true, 6.0);
        event("radio", "x-2", true, 30.0);

        assertThat(texts(tables(), "td")).contains("10 % to 50 %");
    }

    @Test
    void whatIsDetectedAllTheTimeButLostIsNotCalledNone() throws IOException {
        event("radio", "x-1", true, 0.0);
        assertThat(texts(tables(), "p"))
                .containsExactly("None: every sensor detects every drone for at least 99 % of the time.");

        event("radio", "x-1", false, 59.8);
        assertThat(texts(tables(), "p"))
                .containsExactly(
                        "Every sensor detects every drone for at least 99 % of the time, but some lose a drone and"
                                + " do not detect it again.");
        assertThat(texts(tables(), "td"))
                .containsSubsequence("59.8", "before the first look at the drone from then on");
    }

    @Test
    void withoutPairsNothingIsDetected() throws IOException {
        assertThat(texts(tables(List.of()), "p"))
                .containsExactly("The scene has no drone, or no sensor that is switched on.");
    }

    /** Of 63 receivers, one never detects the drone, and the last one always does. */
    @Test
    void onlyPairsThatWouldHaveARowAreNotShown() throws IOException {
        StringBuilder sensors = new StringBuilder();
        for (int i = 0; i < DetectionTables.MAX_ROWS + 3; i++) {
            sensors.append("  s").append(i).append(": ").append(RADIO).append('\n');
            if (i > 0) {
                event("s" + i, "x-1", true, i == DetectionTables.MAX_ROWS + 2 ? 0.0 : 54.0);
            }
        }
        scene("1", sensors.toString());
        Document page = tables();

        assertThat(texts(page, "p"))
                .contains("1 more sensor-drone pair is not shown.")
                .contains(
                        "Some sensors detect a drone, but not all the time. The table below states for what part of the"
                                + " run a sensor does not detect a drone, and why.");
        assertThat(texts(page, "td").stream().filter("90 %"::equals)).hasSize(DetectionTables.MAX_ROWS);
    }
}
