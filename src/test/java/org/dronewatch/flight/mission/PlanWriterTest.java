package org.dronewatch.flight.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Stream;
import org.dronewatch.flight.Dive;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.flight.PopUp;
import org.dronewatch.flight.TerrainFollowing;
import org.dronewatch.flight.file.EquatorSite;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Ground;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.Places;
import org.dronewatch.world.WorldSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What is written reads back as the same flight. */
class PlanWriterTest {
    private static final Ground HILLS = (x, y) -> OptionalDouble.of(15.0 * Math.sin(x / 60.0) * Math.cos(y / 45.0));
    private static final Places PLACES = new Places(WorldSettings.EMPTY.withOrigin(EquatorSite.ORIGIN), () -> HILLS);

    private static PlanFile read(PlanWriter.Written written) {
        return PlanFile.read("a.plan", written.text().getBytes(StandardCharsets.UTF_8));
    }

    private static PlanWriter.Written written(FlightPath path, double until) {
        return new PlanWriter(EquatorSite.ORIGIN, PLACES, false).write(path, until);
    }

    private static FlightPath back(PlanWriter.Written written) {
        Mission settings = new Mission("a.plan", Optional.of(100.0), Optional.of(100.0));
        List<String> warnings = new ArrayList<>();
        FlightPath path = new PlannedFlight(settings, read(written)).path(PLACES, Plans.DRONE, warnings::add);
        assertThat(warnings).isEmpty();
        return path;
    }

    static Stream<FlightPathSettings> flights() {
        Position far = new Position(600, 300, 90);
        return Stream.of(
                new FlightPathSettings.Approach(new Position(-300, 40, 60), far),
                new FlightPathSettings.Waypoints(
                        List.of(new Position(0, 0, 80), new Position(200, 0, 80), new Position(200, 150, 120), far)),
                FlightPathSettings.Orbit.about(new Position(30, -20, 70), 80.0),
                new FlightPathSettings.Glide(
                        new Position(-400, 0, 60), new Position(0, 0, 180), new Position(500, 80, 60)),
                Dive.from(new Position(10, 0, 20), 300.0, 100.0),
                TerrainFollowing.over(List.of(new GroundPoint(-300, -200), new GroundPoint(200, 100)), 25.0));
    }

    private static double nearest(Position place, List<Position> others) {
        return others.stream().mapToDouble(place::distance).min().orElseThrow();
    }

    /** No point of either flight is further from the other than the tolerance, but for the climb from the launch. */
    @ParameterizedTest
    @MethodSource("flights")
    void theLinesAreTheSame(FlightPathSettings flight) {
        FlightPath path = flight.create(12.0, 2.5, HILLS);
        PlanWriter.Written written = written(path, 60.0);
        FlightPath back = back(written);
        List<Position> first = new ArrayList<>();
        List<Position> second = new ArrayList<>();
        for (int i = 0; i <= 1200; i++) {
            first.add(path.at(0.05 * i).position());
        }
        for (int i = 0; i <= 40_000; i++) {
            second.add(back.at(0.05 * i).position());
        }
        assertThat(written.tolerance()).isEqualTo(0.5);
        for (int i = 0; i < first.size(); i += 7) {
            assertThat(nearest(first.get(i), second)).as("%s s", 0.05 * i).isLessThan(0.8);
        }
        Position start = first.get(0);
        for (int i = 0; i < second.size(); i += 101) {
            Position at = second.get(i);
            boolean climbs = Math.hypot(at.x() - start.x(), at.y() - start.y()) < 0.01 && at.z() < start.z();
            assertThat(climbs ? 0.0 : nearest(at, first)).as("%s s", 0.05 * i).isLessThan(0.8);
        }
    }

    /** A straight flight is a take-off and a waypoint at its speed. */
    @Test
    void whatIsStraightHasNoMoreItems() {
        PlanWriter.Written written = written(
                new FlightPathSettings.Approach(new Position(0, 0, 60), new Position(600, 0, 60))
                        .create(12.0, 2.5, HILLS),
                60.0);
        assertThat(written.items()).isEqualTo(2);
        PlanFile plan = read(written);
        assertThat(plan.speed().orElseThrow()).isEqualTo(12.0, within(1e-3));
        assertThat(plan.homeHeight().orElseThrow()).isEqualTo(100.0, within(1e-3));
        assertThat(written.text()).startsWith("{\"fileType\": \"Plan\", \"groundStation\": \"dronewatch\",\n");
        assertThat(PlanWriter.FIRST_LINE
                        .matcher(written.text().lines().findFirst().orElseThrow())
                        .matches())
                .isTrue();
    }

    /** A mission with waits, speeds and a landing comes back step by step, and as a plan of the same length. */
    @Test
    void aMissionComesBack() {
        Plans plan = new Plans()
                .item(22, 3, 0, 0, 0, "null", 0, 0, 30)
                .item(16, 3, 7, 0, 0, "null", 1.003, 2.0, 30)
                .item(178, 2, 1, 12, -1, 0, 0, 0, 0)
                .waypoint(3, 1.003, 2.01, 60)
                .item(21, 3, 0, 0, 0, "null", 0, 0, 0);
        plan.ground = HILLS;
        FlightPath path = plan.fly();
        PlanWriter.Written written = written(path, 400.0);
        assertThat(read(written).steps().stream().map(step -> step.getClass().getSimpleName()))
                .containsExactly("TakeOff", "FlyTo", "Speed", "FlyTo", "Land");
        FlightPath back = new PlannedFlight(Mission.of("a.plan"), read(written)).path(PLACES, Plans.DRONE, line -> {});
        for (int i = 0; i <= 800; i++) {
            assertThat(back.at(0.5 * i).position().distance(path.at(0.5 * i).position()))
                    .as("%s s", 0.5 * i)
                    .isLessThan(3.0);
        }
        assertThat(back.at(400).position().distance(path.at(400).position())).isLessThan(0.05);
    }

    @Test
    void waitsAndStillDronesAreWritten() {
        PlanWriter.Written still =
                written(FlightPathSettings.Hover.at(new Position(5, 6, 70)).create(5, 2.5, HILLS), 100.0);
        assertThat(still.items()).isEqualTo(1);
        assertThat(back(still).at(1e4).position().distance(new Position(5, 6, 70)))
                .isLessThan(0.01);
        FlightPath popUp = new PopUp(new Position(0, 0, 30), 20.0, 40.0).create(5.0, 2.5, HILLS);
        PlanWriter.Written waiting = written(popUp, 60.0);
        assertThat(read(waiting).steps()).anySatisfy(step -> assertThat(step)
                .isInstanceOfSatisfying(MissionStep.Wait.class, wait -> assertThat(wait.seconds())
                        .isEqualTo(20.0, within(0.3))));
    }

    /** Many bends are fewer waypoints with a larger tolerance. */
    @Test
    void aLongFlightHasAtMostAThousandWaypoints() {
        FlightPath circles =
                FlightPathSettings.Orbit.about(new Position(0, 0, 70), 300.0).create(20.0, 2.5, HILLS);
        PlanWriter.Written written = written(circles, 10_000.0);
        assertThat(written.items()).isLessThan(1010);
        assertThat(written.tolerance()).isGreaterThan(0.5);
    }
}
