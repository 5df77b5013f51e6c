package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Causes made to happen on purpose, a sensor for each; those that depend on geometry are in DetectionFieldTest. */
class FieldCausesTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 300, 20, List.of(12.0));

    @TempDir
    private Path directory;

    private void eachCell(DetectionField field, Check check) {
        for (int cell = 0; cell < field.grid().cells(); cell++) {
            int column = cell % field.grid().columns();
            int row = cell / field.grid().columns();
            for (int course = 0; course < field.courses().size() && field.isOpen(0, column, row); course++) {
                Position middle = field.middle(0, column, row);
                check.of(middle, field.courses().get(course), field.cause(0, 0, column, row, course));
            }
        }
    }

    private interface Check {
        void of(Position middle, Course course, Cause cause);
    }

    /** A receiver whose band does not contain the drone's frequency. */
    @Test
    void aDroneThatCannotBeReceivedIsSilent() throws IOException {
        FieldSite site = FieldSite.in(
                directory, "  radio: {kind: rf, position: [0, 0, 4], minFrequency: 5e9, maxFrequency: 6e9}\n");
        eachCell(site.field(GRID, 2), (middle, course, cause) -> assertThat(cause)
                .isEqualTo(Cause.SILENT));
    }

    /** A radar that follows up to 8 m/s, where the drone flies at 12 m/s. */
    @Test
    void aDroneMayBeTooFast() throws IOException {
        FieldSite site =
                FieldSite.in(directory, FieldSite.ROUND.replace("minSpeed: 3 m/s", "minSpeed: 3 m/s, maxSpeed: 8 m/s"));
        Set<Cause> met = EnumSet.noneOf(Cause.class);
        eachCell(site.field(GRID, 2), (middle, course, cause) -> {
            Position line = middle.minus(new Position(0, 0, 4));
            double radial = Math.abs(line.dot(course.at(middle, 12).velocity())) / line.length();
            if (line.length() < 149 && Math.hypot(line.x(), line.y()) > line.z()) {
                boolean isTooFast = radial > 8 + 1e-9;
                assertThat(cause == Cause.TOO_FAST).as("%s %s", middle, course).isEqualTo(isTooFast);
                met.add(cause);
            }
        });
        assertThat(met).contains(Cause.TOO_FAST, Cause.TOO_SLOW, Cause.DETECTED);
    }

    /** A radar that does not reach any cell: hidden where no part of the drone is visible, too weak elsewhere. */
    @Test
    void aDroneInSightMayBeTooFaint() throws IOException {
        FieldSite site = FieldSite.in(
                directory, FieldSite.ROUND.replace("minSpeed: 3", "minSpeed: 0").replace("range: 5000", "range: 1"));
        Set<Cause> met = EnumSet.noneOf(Cause.class);
        Position radar = new Position(0, 0, 4);
        eachCell(site.field(GRID, 2), (middle, course, cause) -> {
            Position line = middle.minus(radar);
            Optional<Cause> hidden = FieldSite.hidden(radar, middle);
            boolean isClear = hidden.equals(FieldSite.hidden(radar, middle.plus(new Position(0.5, 0.5, 0.5))))
                    && hidden.equals(FieldSite.hidden(radar, middle.plus(new Position(-0.5, -0.5, -0.5))))
                    && hidden.equals(FieldSite.hidden(radar, middle.plus(new Position(-0.5, 0.5, -0.5))))
                    && hidden.equals(FieldSite.hidden(radar, middle.plus(new Position(0.5, -0.5, -0.5))));
            if (isClear && line.length() < 149 && Math.hypot(line.x(), line.y()) > line.z()) {
                assertThat(cause).as("%s", middle).isEqualTo(hidden.orElse(Cause.TOO_WEAK));
                met.add(cause);
            }
        });
        assertThat(met).contains(Cause.TOO_WEAK, Cause.HIDDEN_BY_BUILDING);
    }

    /** Ground of 200 x 200 m with a hole of 30 x 30 m in the middle: what is behind it cannot be known. */
    @Test
    void whatIsBehindAHoleIsUnknown() throws IOException {
        StringBuilder text =
                new StringBuilder("ncols 41\nnrows 41\nxllcenter 499900\nyllcenter 5538530.74\ncellsize 5\n");
        for (int row = 0; row < 41; row++) {
            for (int column = 0; column < 41; column++) {
                text.append(Math.abs(row - 20) < 3 && Math.abs(column - 20) < 3 ? "-9999 " : "200 ");
            }
            text.append('\n');
        }
        Files.writeString(directory.resolve("ground.asc"), text);
        Path file = directory.resolve("site.yaml");
        Files.writeString(
                file,
                """
                world:
                  origin: {latitude: 50.0 deg, longitude: 15.0 deg, height: 200 m}
                  terrain: {file: ground.asc, crs: EPSG:32633, accuracy: 0}
                drones:
                  one: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [60, 60, 12]}}
                sensors:
                  radio: {kind: rf, position: [-80, -2, 10]}
                """);
        SceneRunner runner = new SceneRunner(new SceneFile(file)).notes(note -> {});
        SceneSettings settings = runner.settings();
        Stage stage = runner.stage(settings);
        FieldGrid grid = new FieldGrid(0, 0, 250, 10, List.of(12.0));
        Drone drone = DetectionField.droneOf(stage, "one");
        DetectionField field = FieldAssessment.of(
                settings, stage, "one", grid, Course.all(settings.enabledSensors(), drone), cells -> {});
        FieldCoverage coverage = new FieldCoverage(field, FieldCoverage.Choice.WORST, 0.5);
        int[] found = new int[3];
        for (int cell = 0; cell < grid.cells(); cell++) {
            int column = cell % grid.columns();
            int row = cell / grid.columns();
            double x = grid.x(column);
            double y = grid.y(row);
            boolean isOff = Math.max(Math.abs(x), Math.abs(y)) > 101 || Math.max(Math.abs(x), Math.abs(y)) < 14;
            boolean isBehind = isOff || crosses(x, y, 14);
            boolean isClear = Math.max(Math.abs(x), Math.abs(y)) < 99 && !crosses(x, y, 16);
            if (isBehind || isClear) {
                assertThat(coverage.isUnknown(0, column, row))
                        .as("%s, %s", x, y)
                        .isEqualTo(isBehind);
                assertThat(coverage.isCovered(0, column, row))
                        .as("%s, %s", x, y)
                        .isEqualTo(isClear);
                found[isOff ? 0 : isBehind ? 1 : 2]++;
            }
            if (isBehind && !isOff) {
                assertThat(field.cause(0, 0, column, row, 0)).isEqualTo(Cause.UNKNOWN);
                assertThat(field.step(0, 0, column, row, 0)).isZero();
            }
        }
        assertThat(found).doesNotContain(0);
    }

    /** Whether the line from the receiver to a point passes through a square around the origin. */
    private static boolean crosses(double x, double y, double half) {
        for (double share = 0.0; share <= 1.0; share += 1e-3) {
            double east = -80 + share * (x + 80);
            double north = -2 + share * (y + 2);
            if (Math.max(Math.abs(east), Math.abs(north)) < half) {
                return true;
            }
        }
        return false;
    }
}
