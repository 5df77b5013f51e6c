package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.FlightPerformance;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Which courses there are, and where the nose points on them. */
class CourseTest {
    /** Of these, only the first may miss a drone that crosses its line of sight. */
    private static final String SENSORS = FieldSite.ROUND
            + """
              west: {kind: radar, position: [-120, 40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg,
                budget: {range: 120, crossSection: 0.01}, minSpeed: 0 m/s}
              radio: {kind: rf, position: [0, 5, 4], threshold: 12}
              eye: {kind: camera, position: [0, 0, 4], fov: 40 deg, width: 800, height: 600}
            """;

    private static final Position REFERENCE = new Position(10, 20, 5);
    private static final double CRUISE = 12.0;

    @TempDir
    private static Path directory;

    private static Map<String, SensorSettings<?>> sensors;
    private static Drone hovering;
    private static Drone moving;

    @BeforeAll
    static void read() throws IOException {
        FieldSite site = FieldSite.in(directory, SENSORS);
        sensors = site.settings().enabledSensors();
        hovering = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        moving = new Drone(
                "moving",
                hovering.settings().withPerformance(FlightPerformance.TYPICAL.withHover(false)),
                hovering.tree());
    }

    private static Course course(Course.Kind kind, double angle) {
        return new Course(kind, angle, REFERENCE, Optional.empty());
    }

    @Test
    void thereAreEightDirectionsOfTheCompassFromTheNorthOn() {
        List<Course> courses = Course.all(Map.of(), moving);

        assertThat(courses).hasSize(8);
        for (int i = 0; i < 8; i++) {
            assertThat(courses.get(i).kind()).isEqualTo(Course.Kind.COMPASS);
            assertThat(Math.toDegrees(courses.get(i).heading(REFERENCE))).isCloseTo(45.0 * i, within(1e-12));
        }
    }

    @Test
    void bothDirectionsAcrossTheSightOfASensorThatMayMissThemAreAdded() {
        List<Course> courses = Course.all(sensors, moving);
        Position at = new Position(0, 4, 4);
        Position round = sensors.get("round").position();

        assertThat(sensors).hasSize(4);
        assertThat(courses).hasSize(10).startsWith(Course.all(Map.of(), moving).toArray(Course[]::new));
        assertThat(courses.subList(8, 10))
                .allMatch(course -> course.kind() == Course.Kind.CROSSING)
                .allMatch(course -> course.sensor().equals(Optional.of("round")))
                .allMatch(course -> course.reference().equals(round));
        assertThat(courses.get(8).heading(at)).isCloseTo(0.5 * Math.PI, within(1e-12));
        assertThat(courses.get(9).heading(at)).isCloseTo(-0.5 * Math.PI, within(1e-12));
    }

    @Test
    void onlyADroneThatCanHoverHovers() {
        assertThat(Course.all(sensors, hovering))
                .hasSize(11)
                .startsWith(Course.all(sensors, moving).toArray(Course[]::new));
        assertThat(Course.all(sensors, hovering).get(10).kind()).isEqualTo(Course.Kind.HOVER);
        assertThat(Course.all(sensors, moving)).noneMatch(course -> course.kind() == Course.Kind.HOVER);
    }

    @Test
    void atAnotherSpeedItIsTheSameButDoesNotHover() {
        List<Course> slow = Course.at(3.0, sensors, hovering);

        assertThat(slow)
                .hasSize(10)
                .allMatch(course -> course.speed().equals(OptionalDouble.of(3.0)))
                .allMatch(course -> course.glide().isEmpty());
        for (int i = 0; i < 10; i++) {
            Course cruising = Course.all(sensors, hovering).get(i);
            assertThat(slow.get(i).heading(REFERENCE)).isEqualTo(cruising.heading(REFERENCE));
            assertThat(slow.get(i).at(REFERENCE, CRUISE).velocity().length()).isCloseTo(3.0, within(1e-12));
            assertThat(cruising.at(REFERENCE, CRUISE).velocity().length()).isCloseTo(CRUISE, within(1e-12));
        }
    }

    /** Clockwise from north, from or to (10, 20). */
    @ParameterizedTest
    @CsvSource({
        "COMPASS, 30, 50, 25, 30",
        "HOVER, 0, 50, 25, 0",
        "CROSSING, 90, 10, 60, 90",
        "CROSSING, 90, 50, 20, 180",
        "CROSSING, -90, 50, 20, 0",
        "CROSSING, 90, 10, -20, 270",
        "CROSSING, 90, 0, 10, -45",
        "CROSSING, 90, 10, 20, 90",
        "INBOUND, 0, 10, -20, 0",
        "INBOUND, 0, -30, 20, 90",
        "INBOUND, 0, 10, 60, 180",
        "INBOUND, 0, 50, 20, -90",
        "INBOUND, 0, 0, 10, 45",
        "INBOUND, 20, 0, 10, 65",
        "INBOUND, 0, 10, 20, 0"
    })
    void theHeadingDependsOnTheKindAndThePlace(Course.Kind kind, double angle, double x, double y, double heading) {
        assertThat(Math.toDegrees(course(kind, Math.toRadians(angle)).heading(new Position(x, y, 70))))
                .isCloseTo(heading, within(1e-12));
    }

    @Test
    void aCourseTowardsAPointEndsThere() {
        Position at = new Position(-290, 420, 100);
        Position velocity = Course.inbound(REFERENCE).at(at, CRUISE).velocity();

        // 500 m away in plan view: 300 m to the east and 400 m to the south.
        assertThat(velocity.distance(new Position(0.6 * CRUISE, -0.8 * CRUISE, 0.0)))
                .isLessThan(1e-12);
        assertThat(Course.inbound(new Position(-290, 421, 0))
                        .at(at, CRUISE)
                        .velocity()
                        .y())
                .isEqualTo(CRUISE);
    }

    @Test
    void aDroneFliesLevelAndNoseFirstAtItsCruiseSpeed() {
        FlightState state = course(Course.Kind.COMPASS, Math.toRadians(30.0)).at(REFERENCE, CRUISE);

        assertThat(state.position()).isEqualTo(REFERENCE);
        assertThat(state.heading()).isEqualTo(Math.toRadians(30.0));
        assertThat(state.velocity().distance(new Position(6.0, CRUISE * Math.sqrt(0.75), 0.0)))
                .isLessThan(1e-12);
        assertThat(state.isPowered()).isTrue();
    }

    @Test
    void aHoveringDroneIsAtRestWhateverItsSpeed() {
        FlightState state = course(Course.Kind.HOVER, 0.0).at(REFERENCE, CRUISE);

        assertThat(state.velocity()).isEqualTo(new Position(0.0, 0.0, 0.0));
        assertThat(state.heading()).isZero();
    }

    @Test
    void aGlidingDroneDescendsOnItsCourse() {
        GlideDescent glide = new GlideDescent(5.0, 0.75, 360.0);
        Course course = new Course(
                Course.Kind.INBOUND, 0.0, REFERENCE, Optional.empty(), Optional.of(glide), OptionalDouble.empty());
        FlightState state = course.at(new Position(-30, 20, 90), CRUISE);

        assertThat(state.velocity().distance(new Position(3.0, 0.0, -4.0))).isLessThan(1e-12);
        assertThat(state.isPowered()).isFalse();
    }

    @Test
    void aboutAnotherPointOnlyTheReferenceIsDifferent() {
        Position other = new Position(-1, -2, -3);
        Optional<GlideDescent> glide = Optional.of(new GlideDescent(5.0, 0.75, 360.0));
        Course course =
                new Course(Course.Kind.CROSSING, 0.3, REFERENCE, Optional.of("round"), glide, OptionalDouble.of(4.0));

        assertThat(course.about(other))
                .isEqualTo(new Course(
                        Course.Kind.CROSSING, 0.3, other, Optional.of("round"), glide, OptionalDouble.of(4.0)));
    }

    /** Those of the compass and hovering have a fixed heading; the others depend on the place. */
    @Test
    void coursesOnTheSameFixedHeadingShareTheirFirst() {
        List<Course> courses = List.of(
                course(Course.Kind.CROSSING, 0.0),
                course(Course.Kind.COMPASS, 1.0),
                course(Course.Kind.COMPASS, 0.0),
                course(Course.Kind.INBOUND, 0.0),
                course(Course.Kind.HOVER, 0.0),
                course(Course.Kind.CROSSING, 0.0),
                course(Course.Kind.COMPASS, 2.0),
                course(Course.Kind.COMPASS, 1.0));
        int[] first = {0, 1, 2, 3, 2, 5, 6, 1};

        for (int i = 0; i < first.length; i++) {
            assertThat(Course.firstOnSameHeading(courses, i)).as("course %d", i).isEqualTo(first[i]);
        }
    }
}
