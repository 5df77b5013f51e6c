package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.RouteFlight;
import org.dronewatch.flight.RouteLeg;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.proof.FlownRoute;
import org.dronewatch.route.proof.RepeatedSearch;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.proof.RouteScene;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Sites made for one weak spot each. The weakest route uses it: as flown, the drone is detected far less often than on
 * the straight flight from the same place, and in as many runs as predicted.
 */
class FlownWeakSpotsTest {
    private static final String DRONE = "intruder";
    private static final double SPEED = 12.0;
    private static final double RESPONSE = 5.0;
    private static final int RUNS = 200;

    private static final int NORTH = 0;
    private static final int NORTH_EAST = 1;
    private static final int EAST = 2;

    private static final String PLAIN = "v -400 -400 0\nv 400 -400 0\nv 400 400 0\nv -400 400 0\nf 1 2 3\nf 1 3 4\n";

    /** 25 m high and 5 m thick, 60 m to the north of the middle. */
    private static final String WALL =
            """
            v -200 60 0
            v 0 60 0
            v 0 65 0
            v -200 65 0
            v -200 60 25
            v 0 60 25
            v 0 65 25
            v -200 65 25
            f 1 2 6 5
            f 2 3 7 6
            f 3 4 8 7
            f 4 1 5 8
            f 5 6 7 8
            """;

    private static final String RADAR =
            """
              tower: {kind: radar, position: %s, minRange: 1, maxRange: 900, elevationWidth: 170 deg, rate: 1, minSpeed: %s m/s,
                budget: {range: 200, crossSection: 0.01}, detection: {kind: chance, pulses: 8}}
            """;

    @TempDir
    private Path directory;

    /** A plateau 30 m high; a valley with a floor 30 m wide leads through it from the north, and ends in the south. */
    private static String valley() {
        double[] across = {-400, -60, -15, 15, 60, 400};
        double[] heights = {30, 30, 0, 0, 30, 30};
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < across.length; i++) {
            text.append("v ")
                    .append(across[i])
                    .append(" -400 ")
                    .append(heights[i])
                    .append('\n');
            text.append("v ")
                    .append(across[i])
                    .append(" 400 ")
                    .append(heights[i])
                    .append('\n');
        }
        for (int i = 1; i < 2 * across.length - 2; i += 2) {
            text.append("f %d %d %d\nf %d %d %d\n".formatted(i, i + 2, i + 3, i, i + 3, i + 1));
        }
        return text.toString();
    }

    /** What is found from a direction, and how it is flown. */
    private record Flown(SectorRoute route, FlownRoute flown, FlownRoute straight, RouteProof proof) {
        /** The probability that the drone is detected, in time if there is a response. */
        double detection(double response) {
            return route.inTime(response);
        }

        /** The same on the straight flight from where the route begins to where it ends. */
        double straightOn(double response) {
            double length = route.corners()
                    .get(0)
                    .position()
                    .distance(route.searched().end().position());
            double last = response > 0.0 ? length / SPEED - response : Double.POSITIVE_INFINITY;
            return straight.exposure().detection(last);
        }
    }

    private Flown fly(String world, String sensors, String performance, double response, int sector)
            throws IOException {
        return fly(world, sensors, performance, response, sector, List.of(FlightMode.Kind.values()));
    }

    private Flown fly(
            String world, String sensors, String performance, double response, int sector, List<FlightMode.Kind> kinds)
            throws IOException {
        Path file = directory.resolve("site.yaml");
        Files.writeString(
                file,
                world
                        + """
                        drones:
                          intruder:
                            model: packaged:quadrotor.obj
                            speed: 12 m/s
                            soundLevel: 38
                            radar: {crossSection: 0.01}
                            %s
                            flight: {kind: hover, position: [0, 300, 40]}
                        sensors:
                        %salert: {protect: {centre: [0, 0, 10], radius: 25}, response: %s s}
                        run: {duration: 1 s, seed: 7}
                        """
                                .formatted(performance, sensors, response));
        SceneRunner runner = new SceneRunner(new SceneFile(file)).notes(note -> {});
        SceneSettings settings = runner.settings();
        Stage stage = runner.stage(settings);
        FieldGrid grid = new FieldGrid(0, 0, 600, 20, List.of(5.0, 10.0, 20.0, 40.0));
        try (Workers workers = new Workers(2)) {
            return workers.call(() -> {
                SiteRoutes routes =
                        SiteRoutes.of(fields(settings, stage, grid, kinds), settings, stage, DRONE, Optional.empty());
                SectorRoute found = routes.describe(sector, routes.from(sector).orElseThrow());
                RouteSurvey survey = new RouteSurvey(List.of(found), routes.modes(), routes.target(), response, true);
                RepeatedSearch search = new RepeatedSearch(
                        routes,
                        survey,
                        route -> route.with(FlownRoute.of(scene(settings, routes, route), runner.load(settings))
                                .exposure()));
                search.assess(done -> {});
                search.avoidLateDetections(done -> {});
                search.repeat(done -> {});
                search.avoidLateDetections(done -> {});
                SectorRoute route = search.survey().routes().get(0);
                FlownRoute flown = FlownRoute.toProve(scene(settings, routes, route), runner.load(settings), RUNS);
                RouteFlight straight = RouteFlight.of(
                        route.corners().get(0).position(),
                        List.of(new RouteLeg(route.searched().end().position(), Optional.of(SPEED), true)));
                return new Flown(
                        route,
                        flown,
                        FlownRoute.of(RouteScene.of(settings, DRONE, straight), runner.load(settings)),
                        flown.prove(RUNS, runs -> {}));
            });
        }
    }

    private static SceneSettings scene(SceneSettings settings, SiteRoutes routes, SectorRoute route) {
        return RouteScene.of(settings, DRONE, routes.flight(route.route()).orElseThrow());
    }

    /** By mode in which the drone can fly. */
    private static List<ModeField> fields(
            SceneSettings settings, Stage stage, FieldGrid grid, List<FlightMode.Kind> kinds) {
        Drone drone = DetectionField.droneOf(stage, DRONE);
        List<ModeField> fields = new ArrayList<>();
        List<FlightMode> modes = FlightMode.of(
                        drone.settings(), settings.enabledSensors().values())
                .stream()
                .filter(mode -> kinds.contains(mode.kind()))
                .toList();
        for (FlightMode mode : modes) {
            DetectionField field = FieldAssessment.of(
                    settings, stage, DRONE, grid, mode.courses(settings.enabledSensors(), drone), cells -> {});
            fields.add(mode.with(field, drone.settings()));
        }
        return fields;
    }

    private String world(String name, String model, String role) throws IOException {
        Files.writeString(directory.resolve("plain.obj"), PLAIN);
        Files.writeString(directory.resolve(name), model);
        return "world:\n  backgroundNoise: 20\n  models:\n"
                + (role.equals("terrain") ? "" : "    - {file: plain.obj, upAxis: z, role: terrain}\n")
                + "    - {file: " + name + ", upAxis: z, role: " + role + "}\n";
    }

    private static void assertUsed(Flown flown, double response, double atMost, double straightAtLeast) {
        System.out.printf(
                "FlownWeakSpotsTest: %.3f straight %.3f, %d of %d%n",
                flown.detection(response),
                flown.straightOn(response),
                flown.proof().detection().flown().count(),
                RUNS);
        assertThat(flown.straightOn(response)).isGreaterThan(straightAtLeast);
        assertThat(flown.detection(response)).isLessThan(atMost);
        assertThat(flown.proof().agrees()).isTrue();
    }

    /** Whoever appears from behind the wall is so near that a detection comes too late. */
    @Test
    void aWallIsFlownBehind() throws IOException {
        Flown flown =
                fly(world("wall.obj", WALL, "building"), RADAR.formatted("[0, 0, 4]", 0), "", RESPONSE, NORTH_EAST);

        assertUsed(flown, RESPONSE, 0.5, 0.9);
        assertThat(flown.route().causes().dominant().seconds().get(Cause.HIDDEN_BY_BUILDING))
                .isGreaterThan(5.0);
    }

    /** The radar stands on the plateau, and does not see what flies low between the slopes. */
    @Test
    void aValleyIsFlownThrough() throws IOException {
        Flown flown = fly(
                world("valley.obj", valley(), "terrain"), RADAR.formatted("[120, 0, 34]", 0), "", RESPONSE, NORTH_EAST);

        assertUsed(flown, RESPONSE, 0.5, 0.9);
        assertThat(flown.route().causes().dominant().seconds().get(Cause.HIDDEN_BY_TERRAIN))
                .isGreaterThan(10.0);
        assertThat(flown.route().profile().medianHeight()).isLessThan(20.0);
    }

    /** The radar rejects radial speeds below 3 m/s: whoever circles it at full speed is not detected. */
    @Test
    void aRadarThatMissesCrossingFlightIsCircled() throws IOException {
        Flown flown = fly(
                world("hut.obj", WALL, "building"),
                RADAR.formatted("[0, -100, 4]", 3),
                "",
                0.0,
                EAST,
                List.of(FlightMode.Kind.POWERED));

        assertUsed(flown, 0.0, 0.3, 0.7);
        assertThat(flown.route().causes().dominant().seconds().get(Cause.TOO_SLOW))
                .isGreaterThan(5.0);
    }

    /** Whoever comes slowly is not detected by it, either, not even on the way to the zone in which it stands. */
    @Test
    void itIsApproachedSlowly() throws IOException {
        String radar = RADAR.formatted("[0, 0, 4]", 3);
        Flown slow = fly(world("hut.obj", WALL, "building"), radar, "", 0.0, EAST);
        assertUsed(slow, 0.0, 1e-3, 0.99);
        assertThat(slow.route().route().path().modes()).contains(1);
        assertThat(slow.route().causes().dominant().seconds().get(Cause.TOO_SLOW))
                .isGreaterThan(30.0);
    }

    /** Where a detection would come too late, it does not hurry: it would be seen, and arrives unseen. */
    @Test
    void itIsApproachedSlowlyToTheEnd() throws IOException {
        Flown slow = fly(world("hut.obj", WALL, "building"), RADAR.formatted("[0, 0, 4]", 8), "", RESPONSE, EAST);

        assertThat(slow.straight().exposure().detection(Double.POSITIVE_INFINITY))
                .isGreaterThan(0.99);
        assertThat(slow.route().detection()).isLessThan(1e-3);
        assertThat(slow.proof().detection().flown().count()).isZero();
    }

    /** The slow flight would take 33.8 s: it hurries for the rest of them at the end, when hardly a look is taken. */
    @Test
    void itHurriesAtTheEndIfItHasTo() throws IOException {
        String endurance = "performance: {endurance: 33.6 s}";
        Flown slow =
                fly(world("hut.obj", WALL, "building"), RADAR.formatted("[0, 0, 4]", 8), endurance, RESPONSE, EAST);

        assertThat(slow.route().route().seconds()).isLessThanOrEqualTo(33.6);
        assertThat(slow.route().inTime(RESPONSE)).isLessThan(1e-3);
        assertThat(slow.route().detection()).isBetween(0.1, 0.7);
        assertThat(slow.proof().agrees()).isTrue();
    }

    /** Out of the radar's range, it hurries at the beginning, and arrives unseen. */
    @Test
    void itHurriesAtTheBeginningIfThatSuffices() throws IOException {
        String radar = RADAR.formatted("[0, 0, 4]", 8).replace("range: 200", "range: 100");
        String endurance = "performance: {endurance: 33.6 s}";
        Flown slow = fly(world("hut.obj", WALL, "building"), radar, endurance, RESPONSE, EAST);

        assertThat(slow.straight().exposure().detection(Double.POSITIVE_INFINITY))
                .isGreaterThan(0.99);
        assertThat(slow.route().detection()).isLessThan(1e-3);
    }

    /** The slower a drone, the more looks a corner takes: not even corners may lie beyond the blind headings. */
    @Thorough
    @ParameterizedTest
    @ValueSource(ints = {NORTH, EAST})
    void aSecondRadarIsPassedAtItsBlindHeadings(int sector) throws IOException {
        String second = RADAR.formatted("[150, 100, 8]", 1).replace("tower", "second");
        Flown slow = fly(world("hut.obj", WALL, "building"), RADAR.formatted("[0, 0, 4]", 3) + second, "", 0.0, sector);

        assertUsed(slow, 0.0, 1e-3, 0.99);
    }

    /** A canceller is blind at 8 m/s, too: straight towards it, the drone need not fly any slower. */
    @Thorough
    @Test
    void aCancellerIsApproachedAtItsBlindSpeed() throws IOException {
        String radar = RADAR.formatted("[0, 0, 4]", 0)
                .replace("minSpeed: 0 m/s", "notch: {kind: canceller, pulses: 3, blindSpeed: 8 m/s}");
        Flown slow = fly(world("hut.obj", WALL, "building"), radar, "", 0.0, EAST);

        assertUsed(slow, 0.0, 1e-2, 0.99);
        assertThat(slow.route().route().path().modes()).contains(1);
        assertThat(slow.route().route().seconds()).isLessThan(60.0);
    }

    /** A drone that needs its speed to stay in the air has no such choice. */
    @Test
    void wingsCannotFlySlowly() throws IOException {
        Flown flown = fly(
                world("hut.obj", WALL, "building"),
                RADAR.formatted("[0, 0, 4]", 3),
                "performance: {hover: false, turnRate: 1}",
                0.0,
                EAST);

        assertThat(flown.route().route().path().modes()).containsOnly(0);
        assertThat(flown.detection(0.0)).isGreaterThan(0.9);
    }

    /** A microphone does not hear a drone whose motors are off. */
    @Test
    void aGlideIsNotHeard() throws IOException {
        Flown flown = fly(
                world("hut.obj", WALL, "building"),
                "  ear: {kind: acoustic, position: [0, 0, 2], propagation: {kind: level-model, initialRays: 2, maxOrder: 1}}\n",
                "performance: {glideRatio: 8}",
                0.0,
                EAST);

        assertUsed(flown, 0.0, 0.05, 0.95);
        assertThat(flown.route().route().path().modes()).isSorted().endsWith(1);
    }
}
