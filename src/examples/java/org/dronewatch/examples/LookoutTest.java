package org.dronewatch.examples;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Observation;
import org.dronewatch.statistics.Proportion;
import org.junit.jupiter.api.Test;

class LookoutTest {
    private static final Position EYES = new Position(0, 0, 200);
    private static final Map<String, Double> DISTANCES = Map.of("near", 50.0, "far", 200.0, "farther", 700.0);
    private static final long SEED = 5;

    /** A lookout above the hill, and drones that hover at the same height. */
    static class LookoutOnAMast extends GateWatch {
        @Override
        protected void build() {
            super.build();
            disable("roof");
            add("lookout", new LookoutSettings(EYES, 10.0));
            DISTANCES.forEach((name, distance) -> add(
                    name,
                    DroneSettings.of(
                            loadPackaged("quadrotor.obj"), Hover.at(EYES.plus(new Position(0, distance, 0))))));
        }
    }

    private final Map<String, Integer> looks = new TreeMap<>();
    private final Map<String, Integer> detections = new TreeMap<>();

    private void count(Observation seen) {
        assertThat(seen.probability()).isEqualTo(Math.exp(-seen.range() / 300.0));
        looks.merge(seen.drone(), 1, Integer::sum);
        detections.merge(seen.drone(), seen.isDetected() ? 1 : 0, Integer::sum);
    }

    /** In 401 looks, within intervals that contain the probability 999 times out of 1,000. */
    @Test
    void theLookoutDetectsAsOftenAsStated() {
        System.out.println("LookoutTest: seed " + SEED);
        new SceneRunner(new LookoutOnAMast())
                .seed(SEED)
                .onFrame(frame -> frame.observations().forEach(this::count))
                .run();
        DISTANCES.forEach((name, distance) -> {
            Proportion detected = new Proportion(detections.get(name), looks.get(name));
            assertThat(detected.of()).isEqualTo(401);
            assertThat(detected.wilson(0.999).contains(Math.exp(-distance / 300.0)))
                    .as("%s at %s m", detected, distance)
                    .isTrue();
        });
    }

    /** Coverage keeps probabilities in steps of 0.004. */
    @Test
    void coverageHasTheStatedProbability() {
        SceneRunner runner = new SceneRunner(new LookoutOnAMast());
        SceneSettings settings = runner.settings();
        Stage stage = runner.stage(settings);
        FieldGrid cell = new FieldGrid(60.0, 120.0, 20.0, 20.0, List.of(40.0));
        List<Course> north = List.of(new Course(Course.Kind.COMPASS, 0.0, EYES, Optional.empty()));
        DetectionField field = FieldAssessment.of(settings, stage, "intruder", cell, north, cells -> {});

        double expected = Math.exp(-field.middle(0, 0, 0).distance(EYES) / 300.0);
        assertThat(expected).isBetween(0.4, 0.7);
        assertThat(field.probability(0, 0, 0, 0, 0)).isCloseTo(expected, within(0.002));
        assertThat(field.assess(0, 0, 0, 0, 0).orElseThrow().probability()).isCloseTo(expected, within(1e-12));
    }
}
