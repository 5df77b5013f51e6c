package org.dronewatch.route.proof;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.flight.RouteLeg;
import org.dronewatch.fusion.Confirmation;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two radars that may or may not detect the drone. Each raises an alert by detections in two of three looks. */
class PlainFlightTest {
    private static final int RUNS = 12;

    @TempDir
    private Path directory;

    private SceneSettings scene;
    private ModelCache models;
    private Optional<Confirmation> alerts;

    @BeforeEach
    void load() throws IOException {
        FieldSite site = FieldSite.in(
                directory,
                """
                  fast: {kind: radar, position: [-60, 40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 1,
                    budget: {range: 60, crossSection: 0.01}, minSpeed: 0 m/s, detection: {kind: chance, pulses: 8}}
                  slow: {kind: radar, position: [60, -40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 0.4,
                    budget: {range: 70, crossSection: 0.01}, minSpeed: 0 m/s, detection: {kind: chance, pulses: 8}}
                """);
        RouteFlight flight = RouteFlight.of(
                new Position(-140, 60, 50), List.of(new RouteLeg(new Position(140, -60, 50), Optional.of(12.0), true)));
        scene = RouteScene.of(site.settings(), FieldSite.DRONE, flight);
        scene = SettingsForm.with(scene, "alert", scene.alert().withConfirmation(2, 3));
        alerts = Optional.of(scene.alert().confirm());
        models = new SceneRunner(new SceneFile(directory.resolve("site.yaml"))).load(scene);
    }

    private FlownRun replay(SceneSettings begun, long seed) {
        Stage stage = new Stage(begun, models, begun.run().seed());
        return new SeededFlights(LookSchedule.of(begun, stage, 1), stage.world()).fly(seed, alerts);
    }

    /** From every moment at which the route begins; what the radars see while the drone waits raises no alert. */
    @Test
    void theReplayRaisesTheAlertOfThePlainRun() {
        int raised = 0;
        int later = 0;
        for (double begin : RouteStarts.of(scene.enabledSensors().values())) {
            SceneSettings begun = RouteScene.later(scene, begin);
            for (int run = 0; run < RUNS; run++) {
                long seed = RouteProof.seed(begun, run);
                FlownRun replayed = replay(begun, seed);
                FlownRun plain = new PlainFlight(begun, models).fly(seed, alerts);

                assertThat(ProofRuns.isSame(replayed, plain, begun))
                        .as("from %s s, run %d: %s and %s", begin, run, replayed, plain)
                        .isTrue();
                raised += plain.alert().isPresent() ? 1 : 0;
                later += plain.alert().isPresent()
                                && plain.alert().getAsDouble()
                                        > plain.detection().orElseThrow().look().time()
                        ? 1
                        : 0;
            }
        }
        assertThat(raised).isGreaterThan(RUNS / 2);
        assertThat(later).isEqualTo(raised);
    }

    @Test
    void aRunWithAnotherAlertIsNotTheSame() {
        long seed = 0;
        FlownRun plain = new PlainFlight(scene, models).fly(seed, alerts);
        while (plain.alert().isEmpty()) {
            seed++;
            plain = new PlainFlight(scene, models).fly(seed, alerts);
        }
        FlownRun none = new FlownRun(plain.detection(), OptionalDouble.empty());
        FlownRun late =
                new FlownRun(plain.detection(), OptionalDouble.of(plain.alert().getAsDouble() + 1.0));

        assertThat(ProofRuns.isSame(plain, plain, scene)).isTrue();
        assertThat(ProofRuns.isSame(none, plain, scene)).isFalse();
        assertThat(ProofRuns.isSame(late, plain, scene)).isFalse();
    }
}
