package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.ProbabilityResolution;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Lowest detection heights from the geometry of boxes and beams. */
class DetectableHeightsTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 20, List.of(2.0, 26.0, 60.0));

    @TempDir
    private Path directory;

    private DetectableHeights heights(String sensors, int threads) throws IOException {
        return heights(sensors, GRID, threads);
    }

    private DetectableHeights heights(String sensors, FieldGrid grid, int threads) throws IOException {
        FieldSite site = FieldSite.in(directory, sensors);
        DetectionField field = site.field(grid, threads);
        try (Workers workers = new Workers(threads)) {
            return workers.call(
                    () -> DetectableHeights.of(new FieldCoverage(field, FieldCoverage.Choice.WORST, 0.5), cells -> {}));
        }
    }

    /** In the shadow of a box the height is that at which the drone, 0.6 m wide, emerges from it. */
    @Test
    void inAShadowItIsTheHeightAtWhichTheShadowEnds() throws IOException {
        String radar = FieldSite.ROUND.replace("minSpeed: 3", "minSpeed: 0");
        DetectableHeights found = heights(radar, 1);
        DetectableHeights same = heights(radar, 8);
        Position eye = new Position(0, 0, 4);
        int raised = 0;
        int none = 0;
        for (int cell = 0; cell < GRID.cells(); cell++) {
            int column = cell % GRID.columns();
            int row = cell / GRID.columns();
            double x = GRID.x(column);
            double y = GRID.y(row);
            double height = found.height(column, row);
            assertThat(Double.compare(same.height(column, row), height)).isZero();
            boolean isAside = FieldSite.BOXES.values().stream().anyMatch(box -> box.contains(x, y));
            double range = Math.hypot(x, y);
            if (isAside || range > 130 || range < 70) {
                none += Double.isNaN(height) ? 1 : 0;
                continue;
            }
            double shadow = 0.0;
            for (double z = 0.05; z < 60; z += 0.05) {
                shadow = FieldSite.hidden(eye, new Position(x, y, z)).isPresent() ? z : shadow;
            }
            assertThat(height).as("%s, %s", x, y).isBetween(Math.max(0.0, shadow - 0.5), shadow + 1.2);
            raised += shadow > 2.0 ? 1 : 0;
        }
        assertThat(raised).isGreaterThan(5);
        assertThat(none).as("beyond the range").isPositive();
        assertThat(found.count(60.0)).isEqualTo(GRID.cells() - none);
        assertThat(found.columns()).isEqualTo(GRID.cells());
        assertThat(found.coveredAgain()).isZero();
    }

    /** A microphone behind boxes: where the search for heights ends, its probability passes the one asked for. */
    @Thorough
    @Test
    void ofAMicrophoneItIsTheHeightAtWhichItsProbabilityIsReached() throws IOException {
        String ear =
                """
              ear: {kind: acoustic, position: [0, 0, 4],
                propagation: {kind: level-model, initialRays: 3, reflectionsPerHit: 4, maxOrder: 2, attenuation: 0.01}}
            """;
        FieldSite site = FieldSite.in(directory, ear);
        FieldGrid grid = new FieldGrid(0.7, 110.3, 80, 10, List.of(2.0, 26.0, 60.0));
        DetectableHeights found = heights(ear, grid, 2);
        Assessor assessor = new Assessor(
                "ear", site.settings().enabledSensors().get("ear"), site.stage().world());
        Drone drone = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        int searched = 0;
        for (int cell = 0; cell < grid.cells(); cell++) {
            double height = found.height(cell % grid.columns(), cell / grid.columns());
            double x = grid.x(cell % grid.columns());
            double y = grid.y(cell / grid.columns());
            if (FieldSite.BOXES.values().stream().anyMatch(box -> box.contains(x, y)) || Double.isNaN(height)) {
                continue;
            }
            String as = "at %s, %s: %s m".formatted(x, y, height);
            // The error of two estimates, and the rounding to a step.
            assertThat(probability(assessor, drone, new Position(x, y, height)))
                    .as(as)
                    .isGreaterThan(0.45);
            if (height > 2.0) {
                double lower = Math.max(0.0, height - DetectableHeights.ACCURACY);
                assertThat(probability(assessor, drone, new Position(x, y, lower)))
                        .as(as)
                        .isLessThan(0.55);
                searched++;
            }
        }
        assertThat(searched).isGreaterThan(10);
    }

    private static double probability(Assessor assessor, Drone drone, Position at) {
        return assessor.assessCoarsely(
                        drone.at(new FlightState(at, new Position(0, 0, 0), 0.0, OptionalDouble.empty())),
                        Optional.empty(),
                        new SplittableRandom(5),
                        ProbabilityResolution.upTo(0.998))
                .probability();
    }

    /** Two beams, one above the other. */
    @Test
    void aColumnMayBeCoveredAgainAboveAGap() throws IOException {
        String low = FieldSite.ROUND.replace("minSpeed: 3", "minSpeed: 0").replace("90 deg", "10 deg");
        String high = FieldSite.ROUND
                .replace("minSpeed: 3", "minSpeed: 0")
                .replace("round", "high")
                .replace("90 deg", "20 deg, aim: {azimuth: 0 deg, elevation: 60 deg}");
        DetectableHeights found = heights(low + high, 2);
        int column = GRID.columns() / 2 + 2;
        int row = GRID.columns() / 2;
        // 40.7 m to the east of the radars, above the beam of 5 degrees, and below that from 50 degrees on.
        assertThat(GRID.x(column)).isCloseTo(40.7, within(1e-9));
        assertThat(found.coveredAgainGap(column, row)).isEqualTo(58.0);
        assertThat(found.height(column, row)).isLessThanOrEqualTo(2.0);
        assertThat(found.coveredAgain()).isPositive();
        assertThat(found.largestGap()).isEqualTo(58.0);
        assertThat(found.coveredAgainGap(column + 5, row)).as("140.7 m away").isZero();
    }

    @Test
    void theIntervalsAreHalvedUntilTheyAreNarrow() {
        assertThat(DetectableHeights.rounds(GRID)).isEqualTo(7);
        assertThat(DetectableHeights.rounds(new FieldGrid(0, 0, 10, 1, List.of(0.5, 1.0))))
                .isZero();
        assertThat(DetectableHeights.rounds(new FieldGrid(0, 0, 10, 1, List.of(1.0))))
                .isEqualTo(1);
    }
}
