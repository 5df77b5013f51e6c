package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.FlightPerformance;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class GlideDescentTest {
    @TempDir
    private Path directory;

    private FieldSite site(String sensors, boolean isGlider) throws IOException {
        FieldSite powered = FieldSite.in(directory, sensors);
        SceneSettings settings = powered.settings();
        FlightPerformance performance = FlightPerformance.TYPICAL.withGlide(isGlider ? 12.0 : 0.0, 9.0);
        SceneSettings gliding = settings.withDrone(
                FieldSite.DRONE, settings.drones().get(FieldSite.DRONE).withPerformance(performance));
        return new FieldSite(gliding, new SceneRunner(new SceneFile(directory.resolve("site.yaml"))).stage(gliding));
    }

    @Test
    void descendsAtItsGlideRatioWithColdMotors() throws IOException {
        Drone drone = DetectionField.droneOf(site(FieldSite.ROUND, true).stage(), FieldSite.DRONE);
        FlightState state = new GlideDescent(9.0, 12.0, 360.0).at(new Position(1, 2, 3), Math.PI / 2);

        assertThat(GlideDescent.of(drone.settings())).isEqualTo(new GlideDescent(9.0, 12.0, 360.0));
        assertThat(state.velocity().length()).isCloseTo(9.0, within(1e-12));
        assertThat(state.velocity().x() / -state.velocity().z()).isCloseTo(12.0, within(1e-12));
        assertThat(state.isPowered()).isFalse();
        assertThat(drone.at(state).settings().heat().after(360.0)).isCloseTo(5.0 * Math.exp(-3.0), within(1e-12));
    }

    /** A microphone hears the motors, and a radar does not care. */
    @Test
    void aFieldOfAGlidingDroneIsQuiet() throws IOException {
        FieldSite site = site(
                FieldSite.ROUND + "  ear: {kind: acoustic, position: [0, 0, 4], propagation: {kind: level-model}}\n",
                true);
        Drone drone = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        FieldGrid grid = new FieldGrid(0, 0, 100, 20, List.of(20.0));
        List<Course> courses = Course.gliding(site.settings().enabledSensors(), drone);
        DetectionField gliding =
                FieldAssessment.of(site.settings(), site.stage(), FieldSite.DRONE, grid, courses, cells -> {});
        DetectionField powered = site.field(grid, 1);

        assertThat(courses).hasSize(8 + 2).allMatch(course -> course.glide().isPresent());
        assertThat(powered.probability(1, 0, 2, 2, 0)).isPositive();
        assertThat(gliding.probability(1, 0, 2, 2, 0)).isZero();
        assertThat(gliding.probability(0, 0, 3, 2, 2))
                .isEqualTo(powered.probability(0, 0, 3, 2, 2))
                .isPositive();
    }

    @Test
    void whatCannotGlideHasNoSuchCourses() throws IOException {
        FieldSite site = site(FieldSite.ROUND, false);
        Drone drone = DetectionField.droneOf(site.stage(), FieldSite.DRONE);

        assertThatIllegalArgumentException()
                .isThrownBy(() -> Course.gliding(site.settings().enabledSensors(), drone))
                .withMessage("glide ratio 0: the drone cannot glide");
        assertThat(Course.all(site.settings().enabledSensors(), drone))
                .allMatch(course -> course.glide().equals(Optional.empty()));
    }
}
