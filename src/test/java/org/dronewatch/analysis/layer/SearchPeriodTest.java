package org.dronewatch.analysis.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.Positioner;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Sensors that search: for how long a drone is in view follows from the pattern. */
class SearchPeriodTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 70, 10, List.of(4.0));
    private static final FieldTerms SEARCH = FieldTerms.ONE_LOOK.withPointing(FieldTerms.Turning.SEARCH);

    /** At the height of the drone; 40 degrees wide and high; one pixel suffices. */
    private static final String CAMERA =
            """
              eye: {kind: camera, position: [0, 0, 4], aim: {azimuth: 30 deg, elevation: 0 deg}, fov: 40 deg, width: 800, height: 800,
                rate: 5, positioner: {search: %s}}
            """;

    @TempDir
    private Path directory;

    private FieldSite site(String search) throws IOException {
        return FieldSite.in(Files.createTempDirectory(directory, "site"), CAMERA.formatted(search));
    }

    /** In a cell from which nothing hides the drone, and in which one pixel of it is certain to be seen. */
    private static boolean isClear(Position at) {
        return FieldSite.hidden(new Position(0, 0, 4), at).isEmpty() && at.distance(new Position(0, 0, 4)) > 10;
    }

    private interface Share {
        /** By azimuth from the middle of the pattern, deg. */
        double at(double azimuth);
    }

    /** A sensor detects what is in view: its probability is the fraction of the time in which the azimuth is. */
    private void assertShare(String search, Share expected, double tolerance) throws IOException {
        FieldSite site = site(search);
        DetectionField field = site.field(GRID, SEARCH, 2);
        int compared = 0;
        for (int cell = 0; cell < GRID.cells(); cell++) {
            int column = cell % GRID.columns();
            int row = cell / GRID.columns();
            if (!field.isOpen(0, column, row) || !isClear(field.middle(0, column, row))) {
                continue;
            }
            double azimuth = Math.toDegrees(Math.atan2(GRID.x(column), GRID.y(row))) - 30.0;
            double share = expected.at(Math.IEEEremainder(azimuth, 360.0));
            double found = field.probability(0, 0, column, row, 0);
            assertThat(found).as("%s at %.1f deg", search, azimuth).isCloseTo(share, within(tolerance));
            if (share > tolerance && share < 0.45) {
                assertThat(field.cause(0, 0, column, row, 0)).isEqualTo(Cause.OUT_OF_VIEW);
            } else if (share > 0.55) {
                assertThat(field.cause(0, 0, column, row, 0)).isEqualTo(Cause.DETECTED);
            }
            compared++;
        }
        assertThat(compared).isGreaterThan(20);
    }

    /** A drone of 0.6 m is visible a little longer than its middle; 0.6 m at 15 m are 2.3 degrees. */
    @Test
    void aRotatingCameraSeesEveryAzimuthForTheSameTime() throws IOException {
        assertShare("{kind: round, speed: 20 deg/s}", azimuth -> 40.0 / 360.0, 2.5 / 360 + 0.004);
    }

    /** 80 degrees from edge to edge at a constant rate: what is within 20 degrees of the axis is in view. */
    @Test
    void aSweepSeesItsMiddleLongest() throws IOException {
        assertShare(
                "{kind: sweep, width: 80 deg}",
                azimuth -> {
                    double from = Math.max(-40.0, azimuth - 20.0);
                    double to = Math.min(40.0, azimuth + 20.0);
                    return Math.max(0.0, to - from) / 80.0;
                },
                2.5 / 80 + 0.006);
    }

    /** Without a search, the positioner rests: the same as a fixed mount with the same aim, and zoomed out. */
    @Test
    void aPositionerWithoutASearchIsAFixedMount() throws IOException {
        FieldSite resting = FieldSite.in(
                Files.createTempDirectory(directory, "site"),
                CAMERA.formatted("{kind: rest}, zoom: {cued: 8 deg, tracked: 2 deg}"));
        FieldSite fixed = FieldSite.in(
                Files.createTempDirectory(directory, "site"), CAMERA.replace(", positioner: {search: %s}", ""));
        assertSame(resting.field(GRID, SEARCH, 2), fixed.field(GRID, 2));
        assertSame(fixed.field(GRID, SEARCH, 2), fixed.field(GRID, 2));
    }

    private static void assertSame(DetectionField one, DetectionField other) {
        int seen = 0;
        for (int cell = 0; cell < GRID.cells(); cell++) {
            int column = cell % GRID.columns();
            int row = cell / GRID.columns();
            for (int course = 0; course < one.courses().size(); course++) {
                int steps = one.step(0, 0, column, row, course);
                assertThat(steps).isEqualTo(other.step(0, 0, column, row, course));
                assertThat(one.cause(0, 0, column, row, course)).isEqualTo(other.cause(0, 0, column, row, course));
                seen += steps > 0 ? 1 : 0;
            }
        }
        assertThat(seen).isPositive();
    }

    /** Each look of one period of a raster that a slow positioner cannot quite follow, taken as in a run. */
    @Thorough
    @Test
    void theMeanIsThatOfTheLooksOfARun() throws IOException {
        FieldSite site =
                site("{kind: sweep, width: 60 deg, height: 20 deg, rows: 2, speed: 30 deg/s}, panSpeed: 35 deg/s");
        DetectionField field = site.field(GRID, SEARCH, 2);
        SensorSettings<?> settings = site.settings().enabledSensors().get("eye");
        Positioner positioner =
                settings.as(Mounted.class).orElseThrow().createPositioner().orElseThrow();
        Sensor sensor = settings.create();
        int looks = 400;
        double period = 8.0;
        int[] counts = new int[GRID.cells()];
        Drone sample = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        for (int i = 0; i < 2 * looks; i++) {
            Look look = Look.of(7, "eye", i, 0.0).withPointing(Optional.of(positioner.moveTo(i * period / looks)));
            for (int cell = 0; cell < counts.length && i >= looks; cell++) {
                int column = cell % GRID.columns();
                int row = cell / GRID.columns();
                if (field.isOpen(0, column, row)) {
                    Drone there = sample.at(field.courses()
                            .get(0)
                            .at(field.middle(0, column, row), sample.settings().speed()));
                    counts[cell] += sensor.observe(site.stage().world(), List.of(there), look).stream()
                                    .anyMatch(seen -> seen.isDetected())
                            ? 1
                            : 0;
                }
            }
        }
        int between = 0;
        for (int cell = 0; cell < counts.length; cell++) {
            double share = (double) counts[cell] / looks;
            assertThat(field.probability(0, 0, cell % GRID.columns(), cell / GRID.columns(), 0))
                    .as("cell %d", cell)
                    .isCloseTo(share, within(0.02));
            between += share > 0.1 && share < 0.9 ? 1 : 0;
        }
        assertThat(between).isGreaterThan(5);
    }

    /**
     * A turning camera with three seconds for a drone: of the 720 looks of a period taken as in a run, the share of
     * those from which on one of 60 detects it. Looks of a camera that turns are not independent.
     */
    @Test
    void withinATimeTheShareOfTheStartsOfARunThatDetect() throws IOException {
        FieldSite site = FieldSite.in(
                Files.createTempDirectory(directory, "site"),
                CAMERA.replace("rate: 5", "rate: 20").formatted("{kind: round, speed: 10 deg/s}"));
        DetectionField field = site.field(GRID, SEARCH.withWithin(3.0), 2);
        DetectionField longer = site.field(GRID, SEARCH.withWithin(36.0), 2);
        SensorSettings<?> settings = site.settings().enabledSensors().get("eye");
        Positioner positioner =
                settings.as(Mounted.class).orElseThrow().createPositioner().orElseThrow();
        Sensor sensor = settings.create();
        Drone sample = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        List<Optional<Pointing>> pointings = new ArrayList<>();
        for (int i = 0; i < 2 * 720; i++) {
            Optional<Pointing> now = Optional.of(positioner.moveTo(i / 20.0));
            if (i >= 720) {
                pointings.add(now);
            }
        }
        int between = 0;
        for (int cell = 0; cell < GRID.cells(); cell += 5) {
            int column = cell % GRID.columns();
            int row = cell / GRID.columns();
            if (!field.isOpen(0, column, row)) {
                continue;
            }
            Drone there = sample.at(field.courses()
                    .get(0)
                    .at(field.middle(0, column, row), sample.settings().speed()));
            BitSet detected = new BitSet();
            for (int i = 0; i < 720; i++) {
                Look look = Look.of(7, "eye", i, 0.0).withPointing(pointings.get(i));
                detected.set(
                        i,
                        sensor.observe(site.stage().world(), List.of(there), look).stream()
                                .anyMatch(seen -> seen.isDetected()));
            }
            int starts = 0;
            for (int first = 0; first < 720; first++) {
                boolean isDetected = false;
                for (int i = 0; i < 60; i++) {
                    isDetected |= detected.get((first + i) % 720);
                }
                starts += isDetected ? 1 : 0;
            }
            assertThat(field.step(0, 0, column, row, 0))
                    .as("cell %d", cell)
                    .isEqualTo(ProbabilityStep.of(starts / 720.0));
            assertThat(longer.step(0, 0, column, row, 0))
                    .as("cell %d, in a whole period", cell)
                    .isEqualTo(detected.isEmpty() ? 0 : ProbabilityStep.CERTAIN);
            between += starts > 72 && starts < 648 ? 1 : 0;
        }
        assertThat(between).isGreaterThan(4);
    }
}
