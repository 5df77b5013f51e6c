package org.dronewatch.flight.mission;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Optional;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.file.DamagedFiles;
import org.dronewatch.flight.file.DroneSpeeds;
import org.dronewatch.flight.file.EquatorSite;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class MissionTest {
    private static void assertAt(FlightState state, Position place) {
        assertThat(state.position().distance(place))
                .as("%s, not %s", state.position(), place)
                .isLessThan(1e-6);
    }

    /** From rest to rest: length / speed + speed / acceleration. */
    private static double duration(Position from, Position to, double speed) {
        return from.distance(to) / speed + speed / 2.5;
    }

    /** Take-off, waypoint with a wait, another speed, landing: places and times by hand. */
    @Test
    void aMissionIsFlownStepByStep() {
        Plans plan = new Plans()
                .item(22, 3, 0, 0, 0, "null", 0, 0, 30)
                .item(16, 3, 5, 0, 0, "null", 1.003, 2.0, 30)
                .item(178, 2, 1, 12, -1, 0, 0, 0, 0)
                .waypoint(0, 1.003, 2.01, 160)
                .item(21, 3, 0, 0, 0, "null", 0, 0, 0);
        FlightPath path = plan.fly();
        assertThat(plan.warnings).isEmpty();

        Position home = EquatorSite.at(1.0, 2.0, 100.0);
        Position top = EquatorSite.at(1.0, 2.0, 130.0);
        Position north = EquatorSite.at(1.003, 2.0, 130.0);
        Position east = EquatorSite.at(1.003, 2.01, 160.0);
        Position landed = new Position(east.x(), east.y(), 0.0);
        assertAt(path.at(0.0), home);
        double time = duration(home, top, 3.0);
        assertThat(time).isEqualTo(11.2, within(1e-9));
        assertAt(path.at(time), top);
        assertThat(path.at(time - 3.0 / 2.5).velocity().z()).isEqualTo(3.0, within(1e-6));
        time += duration(top, north, 8.0);
        assertAt(path.at(time), north);
        assertAt(path.at(time + 5.0), north);
        assertThat(path.at(time + 2.5).velocity().length()).isZero();
        time += 5.0;
        assertThat(path.at(time + 12.0 / 2.5 + 1.0).velocity().length()).isEqualTo(12.0, within(1e-9));
        time += duration(north, east, 12.0);
        assertAt(path.at(time), east);
        time += duration(east, landed, 1.5);
        assertThat(path.at(time - 5.0).velocity().z()).isEqualTo(-1.5, within(1e-6));
        assertAt(path.at(time), landed);
        assertAt(path.at(time + 1000.0), landed);
        assertThat(path.at(time - 5.0).heading()).isEqualTo(Math.PI / 2, within(1e-3));
    }

    /** Up 30 m and down again, at the drone's own rates unless the settings state others. */
    @ParameterizedTest
    @CsvSource({"NaN, NaN, 6, 2", "4, NaN, 4, 2", "NaN, 1, 6, 1", "0.5, 5, 0.5, 5"})
    void theDroneClimbsAndDescendsAsItCan(double climbRate, double descentRate, double up, double down) {
        Plans plan = new Plans().item(22, 3, 0, 0, 0, "null", 0, 0, 30).item(21, 3, 0, 0, 0, "null", 0, 0, 0);
        plan.drone = new DroneSpeeds(5.0, 2.5, 6.0, 2.0);
        plan.settings = new Mission("a.plan", stated(climbRate), stated(descentRate));
        FlightPath path = plan.fly();

        Position home = EquatorSite.at(1.0, 2.0, 100.0);
        Position top = EquatorSite.at(1.0, 2.0, 130.0);
        double time = duration(home, top, up);
        assertAt(path.at(time), top);
        assertThat(path.at(0.5 * time).velocity().z()).isEqualTo(up, within(1e-9));
        Position landed = new Position(top.x(), top.y(), 0.0);
        double fall = duration(top, landed, down);
        assertThat(path.at(time + 0.5 * fall).velocity().z()).isEqualTo(-down, within(1e-9));
        assertAt(path.at(time + fall), landed);
    }

    private static Optional<Double> stated(double rate) {
        return Double.isNaN(rate) ? Optional.empty() : Optional.of(rate);
    }

    /** What heights count from: the sea, the site's ground at the launch whatever the plan has, the surface below. */
    @Test
    void heightsCountFromWhatTheirFrameSays() {
        Plans plan = new Plans()
                .waypoint(0, 1.001, 2.001, 150)
                .waypoint(3, 1.002, 2.001, 150)
                .waypoint(10, 1.002, 2.002, 50);
        plan.ground = (x, y) -> OptionalDouble.of(y < 150 ? 40.0 : 70.0);
        FlightPath path = plan.fly();
        Position low = EquatorSite.at(1.001, 2.001, 150);
        Position high = EquatorSite.at(1.002, 2.001, 290);
        assertAt(path.at(0.0), low);
        // Climbing 140 m at 3 m/s takes longer than flying 178 m at 8 m/s.
        double time = duration(low, high, 3.0 * low.distance(high) / (high.z() - low.z()));
        assertThat(time).isGreaterThan(46.0);
        assertAt(path.at(time), high);
        assertThat(path.at(1e4).position().z()).isEqualTo(120.0, within(0.01));
        assertThat(plan.warnings)
                .containsExactly(
                        "a.plan: the launch position is 100.0 m above sea level in the plan, 140.0 m on the site:"
                                + " heights are measured from the site");
    }

    /** Between two heights above the surface the drone follows it: brute force over rough ground, seed 26. */
    @Test
    void itFollowsTheSurfaceBetweenHeightsAboveIt() {
        Plans plan = new Plans()
                .waypoint(10, 1.0, 2.0, 30)
                .waypoint(10, 1.004, 2.001, 30)
                .waypoint(10, 1.004, 2.004, 60);
        plan.ground =
                (x, y) -> OptionalDouble.of(20.0 * Math.sin(x / 60.0) * Math.cos(y / 45.0) + (x > 300 ? 25.0 : 0.0));
        FlightPath path = plan.fly();
        SplittableRandom random = new SplittableRandom(26);
        double lowest = Double.POSITIVE_INFINITY;
        double highest = 0.0;
        for (int i = 0; i < 20_000; i++) {
            double time = random.nextDouble(0.0, 400.0);
            Position at = path.at(time).position();
            double above = at.z() - plan.ground.height(at.x(), at.y()).orElseThrow();
            lowest = Math.min(lowest, above);
            highest = Math.max(highest, above);
        }
        assertThat(lowest).isGreaterThan(29.99);
        assertThat(highest).isBetween(59.9, 90.0);
        Position end = EquatorSite.at(1.004, 2.004, 0.0);
        double over = 60.0 + plan.ground.height(end.x(), end.y()).orElseThrow();
        // Between two samples the surface may be higher: there the profile is, too.
        assertThat(path.at(1e4).position().z()).isBetween(over, over + 0.2);
    }

    /** Speeds stay within the limits, and velocity is how position changes: brute force, seed 27. */
    @Test
    void velocityIsTheChangeOfPositionWithinTheLimits() {
        SplittableRandom random = new SplittableRandom(27);
        Plans plan = new Plans().item(22, 3, 0, 0, 0, "null", 1.0005, 2.0005, 40);
        for (int i = 0; i < 30; i++) {
            plan.item(178, 2, 1, random.nextDouble(2.0, 20.0), -1, 0, 0, 0, 0)
                    .waypoint(
                            i % 5 < 3 ? 10 : 3,
                            1.0 + random.nextDouble(-0.004, 0.004),
                            2.0 + random.nextDouble(-0.004, 0.004),
                            random.nextDouble(20.0, 120.0));
        }
        plan.ground = (x, y) -> OptionalDouble.of(15.0 * Math.sin(x / 50.0) * Math.sin(y / 70.0));
        FlightPath path = plan.fly();
        double h = 1e-3;
        for (int i = 0; i < 50_000; i++) {
            double time = random.nextDouble(1.0, 4000.0);
            FlightState state = path.at(time);
            assertThat(state.velocity().z()).as("t %s", time).isBetween(-1.5 - 1e-9, 3.0 + 1e-9);
            assertThat(state.velocity().length()).isLessThan(20.0);
            Position moved =
                    path.at(time + h).position().minus(path.at(time - h).position());
            assertThat(moved.length()).isLessThan(2 * h * 20.0 + 1e-9);
            // At the cuts of a surface the direction changes: there only roughly.
            assertThat(moved.times(0.5 / h).distance(state.velocity()))
                    .as("t %s", time)
                    .isLessThan(2.0);
        }
    }

    @Test
    void itDoesNotStopWhereThePathDoesNotBend() {
        Plans straight = new Plans()
                .waypoint(3, 1.0, 2.0, 50)
                .waypoint(3, 1.001, 2.0, 50)
                .waypoint(3, 1.002, 2.0, 50);
        double time = duration(EquatorSite.at(1.0, 2.0, 150), EquatorSite.at(1.002, 2.0, 150), 8.0);
        FlightPath path = straight.fly();
        assertThat(path.at(time / 2).velocity().length()).isEqualTo(8.0, within(1e-6));
        assertThat(path.at(time + 1e-3).position().distance(EquatorSite.at(1.002, 2.0, 150)))
                .isLessThan(1e-2);
        assertThat(path.at(time - 2.0).velocity().length()).isEqualTo(5.0, within(0.05));

        Plans bent = new Plans()
                .waypoint(3, 1.0, 2.0, 50)
                .waypoint(3, 1.001, 2.0, 50)
                .waypoint(3, 1.002, 2.0005, 50);
        double first = duration(EquatorSite.at(1.0, 2.0, 150), EquatorSite.at(1.001, 2.0, 150), 8.0);
        assertThat(bent.fly().at(first).velocity().length()).isLessThan(1e-3);
    }

    @Test
    void surveysReturnsAndStaysAreFlown() {
        Plans plan = new Plans().item(22, 3, 0, 0, 0, "null", "null", "null", 20);
        plan.items.add(
                "{\"type\": \"ComplexItem\", \"complexItemType\": \"survey\", \"TransectStyleComplexItem\": {\"Items\": ["
                        + new Plans()
                                        .waypoint(3, 1.001, 2.0, 40)
                                        .item(206, 2, 25, 0, 1, 0, 0, 0, 0)
                                        .waypoint(3, 1.001, 2.001, 40)
                                        .item(206, 2, 0, 0, 1, 0, 0, 0, 0)
                                        .items
                                        .stream()
                                        .reduce((a, b) -> a + "," + b)
                                        .orElseThrow()
                        + "]}}");
        plan.item(93, 2, 7, 0, 0, 0, 0, 0, 0).item(20, 2, 0, 0, 0, 0, 0, 0, 0);
        FlightPath path = plan.fly();
        assertAt(path.at(1e5), EquatorSite.at(1.0, 2.0, 100));
        double up = duration(EquatorSite.at(1, 2, 100), EquatorSite.at(1, 2, 120), 3.0);
        Position first = EquatorSite.at(1.001, 2.0, 140);
        double toFirst = duration(EquatorSite.at(1, 2, 120), first, 8.0);
        assertAt(path.at(up + toFirst), first);
        Position second = EquatorSite.at(1.001, 2.001, 140);
        double toSecond = duration(first, second, 8.0);
        assertAt(path.at(up + toFirst + toSecond + 6.9), second);
        assertThat(plan.warnings)
                .containsExactly(
                        "a.plan: mission.items.3: the drone returns at its current height, since the plan does not state another",
                        "a.plan: mission.items.1.TransectStyleComplexItem.Items.1 and 1 more: DO_SET_CAM_TRIGG_DIST (206)"
                                + " does not move the drone, and is left out");

        Plans staying = new Plans()
                .waypoint(3, 1.0, 2.0, 50)
                .item(17, 3, 0, 0, 0, 0, 1.001, 2.0, 50)
                .waypoint(3, 1.005, 2.0, 50);
        assertAt(staying.fly().at(1e5), EquatorSite.at(1.001, 2.0, 150));
        assertThat(staying.warnings)
                .containsExactly("a.plan: 1 step comes after an item at which the drone stays, and is never reached");
    }

    /** Landing patterns of fixed-wings lead straight down to the surface, those of VTOLs above the place, and down. */
    @Test
    void landingPatternsEndOnTheSurface() {
        String pattern =
                "{\"type\": \"ComplexItem\", \"complexItemType\": \"fwLandingPattern\", \"altitudesAreRelative\": true,"
                        + " \"loiterCoordinate\": [1.004, 2.0, 40], \"landCoordinate\": [1.001, 2.0, 0], \"loiterRadius\": 75}";
        Plans wing = new Plans().waypoint(3, 1.004, 2.002, 40);
        wing.items.add(pattern);
        FlightPath path = wing.fly();
        Position approach = EquatorSite.at(1.004, 2.0, 140);
        Position spot = EquatorSite.at(1.001, 2.0, 100);
        double time = duration(EquatorSite.at(1.004, 2.002, 140), approach, 8.0);
        assertAt(path.at(time), approach);
        double down = duration(approach, spot, 8.0);
        Position half = path.at(time + down / 2).position();
        assertThat(half.distance(approach.plus(spot).times(0.5))).isLessThan(1e-3);
        assertAt(path.at(time + down), path.at(1e5).position());
        assertThat(path.at(1e5).position().distance(spot)).isLessThan(0.02);
        assertThat(wing.warnings).containsExactly("a.plan: mission.items.1: the drone does not circle before it lands");

        Plans vtol = new Plans().waypoint(3, 1.004, 2.002, 40);
        vtol.items.add(pattern.replace("fwLandingPattern", "vtolLandingPattern")
                .replace("loiterCoordinate", "landingApproachCoordinate"));
        double over = time + approach.distance(new Position(spot.x(), spot.y(), approach.z())) / 8.0 + 8.0 / 2.5;
        assertThat(vtol.fly().at(over).position().z()).isGreaterThan(39.0);
        assertThat(vtol.fly().at(1e5).position().distance(spot)).isLessThan(0.02);
    }

    /** As QGroundControl wrote places until 2017. */
    @Test
    void olderPlansAreReadToo() {
        Plans plan = new Plans();
        plan.items.add("{\"type\": \"SimpleItem\", \"command\": 16, \"frame\": 3, \"coordinate\": [1.001, 2.0, 50],"
                + " \"params\": [0, 0, 0, null]}");
        assertAt(plan.fly().at(0.0), EquatorSite.at(1.001, 2.0, 150));
    }

    @Test
    void speedsAreThoseOfTheVehicle() {
        Plans wing = new Plans().waypoint(3, 1.0, 2.0, 50).waypoint(3, 1.01, 2.0, 50);
        wing.mission = wing.mission.replace("\"vehicleType\": 2", "\"vehicleType\": 1");
        assertThat(wing.fly().at(20.0).velocity().length()).isEqualTo(20.0, within(1e-9));
        Plans without = new Plans().waypoint(3, 1.0, 2.0, 50).waypoint(3, 1.01, 2.0, 50);
        without.mission = "\"vehicleType\": 2";
        assertThat(without.fly().at(20.0).velocity().length()).isEqualTo(5.0, within(1e-9));
    }

    /** A hole is never ground at height 0. */
    @Test
    void whereTheSiteEndsAMessageNamesThePlace() {
        Plans hole = new Plans().waypoint(0, 1.0, 2.0, 150).waypoint(10, 1.002, 2.0, 50);
        hole.ground = (x, y) -> y > 100 ? OptionalDouble.empty() : OptionalDouble.of(0.0);
        assertThatThrownBy(hole::fly)
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("a.plan: mission.items.1: no surface at latitude 1.002000 deg, longitude 2.000000 deg"
                        + " from which to measure the height: the site has a hole or ends there");

        Plans launch = new Plans().waypoint(3, 1.0, 2.0, 50);
        launch.ground = (x, y) -> OptionalDouble.empty();
        assertAt(launch.fly().at(0.0), EquatorSite.at(1.0, 2.0, 150));
        assertThat(launch.warnings)
                .singleElement()
                .asString()
                .contains("heights are measured from 100.0 m above sea level");
        launch.home = "[1.0, 2.0, null]";
        assertThatThrownBy(launch::fly).hasMessageContaining("no surface at latitude 1.000000 deg");
        Plans far = new Plans().waypoint(0, 40.0, 2.0, 150);
        assertThatThrownBy(far::fly)
                .hasMessageContaining("mission.items.0: latitude 40.000000 deg, longitude 2.000000 deg lies");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "18 | 3 | mission.items.0: NAV_LOITER_TURNS (18) is not supported, and may move the drone",
                "177 | 2 | mission.items.0: DO_JUMP (177) is not supported",
                "4711 | 2 | mission.items.0: command 4711 is not supported",
                "16 | 1 | mission.items.0.frame: 1 must be 0, 3 or 10",
            })
    void whatIsNotUnderstoodIsRefused(int command, int frame, String message) {
        Plans plan = new Plans().item(command, frame, 3, 0, 0, 0, 1.0, 2.0, 30);
        assertThatThrownBy(plan::read).isInstanceOf(InputException.class).hasMessageContaining("a.plan: " + message);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "\"Plan\" | \"Mission\" | a.plan: fileType is 'Mission' but must be 'Plan'",
                "\"command\": 16 | \"command\": \"up\" | mission.items.0.command: must be the number of a MAVLink command",
                "\"command\": 16 | \"command\": 1e300 | mission.items.0.command: must be the number of a MAVLink command",
                "[0, 0, 0, null, 1.0, 2.0, 50.0] | [0] | mission.items.0.params: must be a list of 7 numbers",
                "1.0, 2.0, 50.0 | 91.0, 2.0, 50.0 | mission.items.0: latitude 91.0 must be -90.0 to 90.0",
                "1.0, 2.0, 50.0 | null, 2.0, 50.0 | mission.items.0: latitude null must be -90.0 to 90.0",
                "1.0, 2.0, 50.0 | 1.0, 2.0, 1e9 | mission.items.0: height 1.0E9 must be",
                "[0, 0, 0, null | [-5, 0, 0, null | mission.items.0: time -5 must be 0.0 to",
                "SimpleItem | ComplexItem | complex item '' is not supported: only surveys, corridors and landing patterns are",
                "SimpleItem | Other | mission.items.0: type 'Other' must be SimpleItem or ComplexItem",
                "\"items\" | \"itms\" | mission.items is missing",
                "\"vehicleType\": 2 | \"vehicleType\": 10 | mission.vehicleType 10 is a vehicle that does not fly",
                "[1.0, 2.0, 100] | [1.0, 200.0, 100] | mission.plannedHomePosition: longitude 200.0 must be",
                "\"hoverSpeed\": 8 | \"hoverSpeed\": 8000 | mission: hoverSpeed 8000 must be 0.001 to 400.0",
                "\"version\": 2, | \"version\": 2 | a.plan:1: not valid JSON",
            })
    void whatIsWrongIsRefusedInALine(String old, String wrong, String message) {
        Plans plan = new Plans().waypoint(3, 1.0, 2.0, 50);
        assertThat(plan.text()).contains(old);
        assertThatThrownBy(() -> PlanFile.read(
                        "a.plan", plan.text().replace(old, wrong).getBytes(java.nio.charset.StandardCharsets.UTF_8)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(message)
                .satisfies(e -> assertThat(e.getMessage().lines()).hasSize(1));
    }

    @Test
    void fencesAreLeftOutAndSaid() {
        Plans plan = new Plans().waypoint(3, 1.0, 2.0, 50);
        plan.others =
                ", \"geoFence\": {\"circles\": [{}], \"polygons\": []}, \"rallyPoints\": {\"points\": [[1, 2, 3]]}";
        plan.fly();
        assertThat(plan.warnings).hasSize(2).allMatch(line -> line.contains("it has no effect on the flight"));
        assertThatThrownBy(() -> new Plans().fly()).hasMessageContaining("the mission has no take-off and no waypoint");
    }

    @Test
    void damagedFilesAreReadOrRefused() {
        Plans plan = new Plans()
                .item(22, 3, 0, 0, 0, "null", 0, 0, 30)
                .waypoint(10, 1.001, 2.0, 30)
                .waypoint(10, 1.001, 2.001, 30);
        int refused =
                DamagedFiles.refused(plan.text(), bytes -> new PlannedFlight(plan.settings, PlanFile.read("a", bytes))
                        .path(plan.places(), Plans.DRONE, line -> {}));
        assertThat(refused).isBetween(150, 590);
    }

    @Test
    void whatIsNestedOrLongWithoutEndIsRefused() {
        byte[] deep = "[".repeat(1_000_000).getBytes(java.nio.charset.StandardCharsets.UTF_8);
        assertThatThrownBy(() -> PlanFile.read("a.plan", deep))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(
                        "a.plan: not valid JSON: Document nesting depth (501) exceeds the maximum allowed (500)");
        Plans many = new Plans();
        for (int i = 0; i <= PlanFile.MOST_ITEMS; i++) {
            many.waypoint(3, 1.0, 2.0, i);
        }
        assertThatThrownBy(many::read).hasMessage("a.plan: more than 10000 items");
    }
}
