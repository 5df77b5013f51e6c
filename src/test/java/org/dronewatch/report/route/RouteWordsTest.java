package org.dronewatch.report.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.flight.Airframe;
import org.dronewatch.fusion.ProtectedZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.map.RouteMap;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteProfile;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.ProvenChance;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.proof.UnseenPlaces;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.RoutePath;
import org.dronewatch.route.search.TimeToGo;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.statistics.Proportion;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A route of 30 s with one look after 10 s, which is in time for a response of 15 s, and what is said of it. */
class RouteWordsTest {
    private static final Position START = new Position(0, 300, 30);
    private static final Position END = new Position(0, 0, 30);

    @TempDir
    private Path directory;

    private FieldSite site;
    private RouteInputs inputs;

    @BeforeEach
    void load() throws IOException {
        site = FieldSite.in(
                directory,
                """
                  slow: {kind: radar, position: [0, 0, 4], rate: 0.2, minRange: 1, maxRange: 100, elevationWidth: 90 deg,
                    budget: {range: 500, crossSection: 0.01}, minSpeed: 0 m/s}
                  slower: {kind: radar, position: [0, 0, 4], rate: 0.05, minRange: 1, maxRange: 100,
                    elevationWidth: 90 deg, budget: {range: 500, crossSection: 0.01}, minSpeed: 0 m/s}
                """);
        SceneSettings settings = SettingsForm.with(
                site.settings(), "alert", site.settings().alert().withProtectedZone(ProtectedZone.at(END), 15.0));
        inputs = new RouteInputs(
                "site",
                FieldSite.DRONE,
                settings,
                site.stage().protection(),
                new FieldGrid(0.0, 0.0, 600.0, 20.0, List.of(30.0)),
                FieldTerms.Turning.SEARCH,
                Optional.empty(),
                Optional.empty());
    }

    private static SectorRoute route(
            Map<String, Double> bySensor, double searched, List<List<FlownExposure.Step>> flown) {
        RoutePath path = new RoutePath(List.of(START, END), List.of(0));
        RouteProfile profile = new RouteProfile(List.of(
                new RoutePoint(0, 0, START, 30, 0, 0, true), new RoutePoint(30, 300, END, 30, 0, searched, true)));
        return new SectorRoute(
                0,
                new WeakestRoute(path, searched, 0, 30),
                profile,
                bySensor,
                Map.of(),
                Optional.of(new FlownExposure(flown, bySensor)));
    }

    private RouteResults results(SectorRoute route, Map<Integer, Double> timely) {
        RouteSurvey survey = new RouteSurvey(
                List.of(route), List.of(new RouteMode("powered", 10, 3, 3, Double.POSITIVE_INFINITY)), END, 15.0, true);
        TimeToGo times = null;
        return new RouteResults(survey, new UnseenPlaces(4000, 0), times, Map.of(), timely, true);
    }

    private static FlownExposure.Step look(double time, double exposure) {
        return new FlownExposure.Step(time - 5.0, time, exposure);
    }

    @Test
    void theVerdictStatesWhatDecides() {
        Map<String, Double> three = new LinkedHashMap<>();
        three.put("a", 0.30);
        three.put("b", 0.44);
        three.put("c", 0.26);
        SectorRoute route = route(three, 1.0, List.of(List.of(look(10.0, 0.5), look(20.0, 0.5))));
        String verdict = new RouteWords(inputs).weakest(results(route, Map.of(0, 0.3)));

        assertThat(verdict)
                .contains("the drone is detected, by b (44 %) and a (30 %), with a probability of ")
                .contains(
                        "detected in time with a probability of 39 %, and an alert comes in time with a probability of 30 %");
        three.put("b", 0.60);
        assertThat(new RouteWords(inputs)
                        .weakest(results(
                                route(three, 1.0, route.flown().orElseThrow().flights()), Map.of())))
                .contains("is detected, mostly by b, with a probability of ")
                .contains(". The drone is detected in time with a probability of 39 %.");
    }

    /** Not even a look at the moment at which the flight begins is in time. */
    @Test
    void nothingIsInTimeForAResponseThatTakesLongerThanTheFlight() {
        SectorRoute route = route(Map.of("slow", 2.0), 2.0, List.of(List.of(look(0.0, 2.0))));

        assertThat(route.inTime(30.0)).isGreaterThan(0.8);
        assertThat(route.critical(30.1)).isNegative();
        assertThat(route.inTime(30.1)).isZero();
    }

    @Test
    void theTableStatesTheProofWithCues() {
        SectorRoute route = route(Map.of("slow", 1.0), 1.0, List.of(List.of(look(10.0, 1.0))));
        ProvenChance detection = new ProvenChance(0.6, new Proportion(31, 50));
        ProvenChance alert = new ProvenChance(0.4, new Proportion(9, 50));
        RouteProof proof = new RouteProof(detection, Map.of("slow", 0.6), Optional.of(alert), 3, Optional.empty());
        RouteResults results = results(route, Map.of());
        RouteResults without = new RouteResults(
                results.survey(), results.between(), results.times(), Map.of(0, proof), Map.of(), true);
        RouteResults with = new RouteResults(
                results.survey(),
                results.between(),
                results.times(),
                Map.of(0, proof.with(new Proportion(33, 50))),
                Map.of(),
                true);

        assertThat(RouteTable.lines(without, inputs)).noneMatch(line -> line.contains("with cues"));
        assertThat(RouteTable.lines(with, inputs))
                .anyMatch(line -> line.endsWith("agrees     with cues"))
                .anyMatch(line -> line.contains("31 of 50") && line.endsWith("33 of 50"))
                .anyMatch(line -> line.contains("9 of 50") && line.endsWith("no"))
                .noneMatch(line -> line.startsWith("With cues"));
        RouteResults more = new RouteResults(
                results.survey(),
                results.between(),
                results.times(),
                Map.of(0, proof.with(new Proportion(50, 50))),
                Map.of(),
                true);
        assertThat(RouteTable.lines(more, inputs))
                .contains("With cues, the drone is detected on the route from the north in 50 of 50 flights"
                        + " instead of the predicted 60 %.");
    }

    /** Half of the flights are surely detected in time, and half of them surely not. */
    @Test
    void namesTheScanWhereItIsTheCause() {
        SectorRoute scan =
                route(Map.of("slow", 20.0), 10.0, List.of(List.of(look(14.0, 20.0)), List.of(look(16.0, 20.0))));
        SectorRoute cells = route(Map.of("slow", 20.0), 0.0, List.of(List.of(look(14.0, 20.0))));

        assertThat(scan.inTime(15.0)).isCloseTo(0.5, within(1e-6));
        assertThat(warning(scan))
                .contains("'slow' may look at any moment", "every 5 s")
                .doesNotContain("--cell");
        assertThat(warning(cells)).contains("try --cell 10m").doesNotContain("slow");
    }

    /** Nobody is told to rely on a direction from which the drone arrives before the response does. */
    @Test
    void namesTheDirectionsFromWhichNothingIsInTime() {
        SectorRoute far = route(Map.of("slow", 1.0), 1.0, List.of(List.of(look(10.0, 1.0))));
        RouteProfile profile = new RouteProfile(
                List.of(new RoutePoint(0, 0, START, 30, 0, 0, true), new RoutePoint(10, 100, END, 30, 0, 1, true)));
        SectorRoute near = new SectorRoute(2, far.route(), profile, far.bySensor(), Map.of(), far.flown());
        RouteSurvey alone = results(far, Map.of()).survey();
        RouteSurvey both = new RouteSurvey(List.of(far, near), alone.modes(), END, 15.0, true);
        RouteSurvey nearAlone = new RouteSurvey(List.of(near), alone.modes(), END, 15.0, true);

        assertThat(warning(far)).doesNotContain("no detection");
        assertThat(new RouteNotes(inputs).warnings(both).get(0))
                .contains(
                        "no detection can be in time on the route from the east, which takes 10 s, and the response 15 s");
        assertThat(new RouteNotes(inputs).warnings(nearAlone).get(0))
                .contains("no detection can be in time, because each route takes 10 s, and the response 15 s");
    }

    /** Slow looks detect less than the search expects, so that they are no reason why it expects nothing. */
    @Test
    void doesNotNameTheScanWhereMoreIsDetectedThanExpected() {
        SectorRoute more =
                route(Map.of("slow", 20.0), 0.0, List.of(List.of(look(14.0, 20.0)), List.of(look(16.0, 20.0))));

        assertThat(more.inTime(15.0)).isCloseTo(0.5, within(1e-6));
        assertThat(warning(more)).contains("try --cell 10m").doesNotContain("slow");
    }

    /** A slower one hardly ever detects the drone, so that it makes no difference when it looks. */
    @Test
    void namesTheSensorWhoseLooksDisagreeWithTheSearch() {
        Map<String, Double> looks = new LinkedHashMap<>();
        looks.put("slow", 0.7);
        looks.put("slower", 1e-6);
        SectorRoute route = route(looks, 10.0, List.of(List.of(look(14.0, 20.0)), List.of(look(16.0, 20.0))));

        assertThat(warning(route)).contains("'slow' may look at any moment, whereas it looks only every 5 s");
    }

    /** The search takes the drone for surely detected by one of two slow sensors, whose looks all miss it. */
    @Test
    void namesASensorThatMissesWhatTheSearchExpects() {
        Map<String, Double> looks = new LinkedHashMap<>();
        looks.put("slow", 0.7);
        looks.put("slower", 1e-3);
        Map<String, Double> searched = Map.of("slow", 0.7, "slower", 9.0);
        SectorRoute flown = route(looks, 10.0, List.of(List.of(look(14.0, 20.0)), List.of(look(16.0, 20.0))));
        SectorRoute route = new SectorRoute(0, flown.route(), flown.searched(), searched, Map.of(), flown.flown());

        assertThat(warning(route)).contains("'slower' may look at any moment, whereas it looks only every 20 s");
    }

    @Test
    void theTableTellsTheExposureThatCountsFromThatOfTheWholeRoute() {
        SectorRoute route = route(Map.of("slow", 1.0), 1.0, List.of(List.of(look(10.0, 1.0))));

        assertThat(RouteTable.lines(results(route, Map.of()), inputs).get(1))
                .contains("  counted exposure  lower bound  ");
    }

    /** A descent above a radar is found in smaller cells, a route close to the ground only at lower heights. */
    @Test
    void whatMayBeFoundElsewhereIsLookedForInSmallerCellsAndLower() {
        SectorRoute route = route(Map.of("slow", 3.0), 3.0, List.of(List.of(look(10.0, 3.0))));
        RouteResults results = results(route, Map.of());

        assertThat(new RouteWords(inputs).weakest(results))
                .endsWith(". Routes were searched for in cells of 20 m, 30 m above the ground.");
        assertThat(new RouteNotes(inputs).notes(results))
                .anyMatch(note -> note.startsWith("Less exposed routes from the north cannot be ruled out")
                        && note.contains("try --cell 10m")
                        && note.endsWith("less than 30 m above the ground, add lower --heights."))
                .containsOnlyOnce("Routes more than 30 m above the ground were not searched for, although the drone's"
                        + " ceiling is 500 m; to include them, add higher --heights.");
    }

    /** A leg of 50 m in 10 s: no aircraft with wings flies at less than half its cruise speed of 12 m/s. */
    @Test
    void aDroneThatCannotHoverIsNotSilentlyFlownTooSlowly() {
        SectorRoute route = route(Map.of(), 0.0, List.of(List.of()));
        RouteProfile slow = new RouteProfile(List.of(
                new RoutePoint(0, 0, START, 30, 0, 0, true),
                new RoutePoint(10, 50, new Position(0, 250, 60), 60, 0, 0, true),
                new RoutePoint(30, 300, END, 30, 0, 0, true)));
        RouteResults results =
                results(new SectorRoute(0, route.route(), slow, Map.of(), Map.of(), route.flown()), Map.of());
        RouteInputs winged = with(Airframe.FIXED_WING);

        assertThat(new RouteNotes(winged).notes(results))
                .contains(
                        "The drone cannot hover, but steep legs of the route from the north are flown as slowly as its"
                                + " rates of climb and descent require, down to 5 m/s instead of 12 m/s: a real one would need a"
                                + " longer way there.");
        assertThat(RouteFile.toJson(results, winged).get("notes").toString()).contains("down to 5 m/s");
        assertThat(new RouteNotes(winged).notes(results(route, Map.of()))).noneMatch(note -> note.contains("hover"));
        assertThat(new RouteNotes(inputs).notes(results)).noneMatch(note -> note.contains("hover"));
    }

    private RouteInputs with(Airframe airframe) {
        SceneSettings settings = inputs.settings();
        return new RouteInputs(
                inputs.scene(),
                inputs.drone(),
                settings.withDrone(
                        inputs.drone(), settings.drones().get(inputs.drone()).withAirframe(airframe)),
                inputs.protection(),
                inputs.grid(),
                inputs.pointing(),
                inputs.launch(),
                inputs.stopped());
    }

    /** Looks at any moment would detect much more than in the cells, slow ones do not: no warning says so. */
    @Test
    void whatNoWarningSaysIsNoted() {
        SectorRoute route = route(Map.of("slow", 1.3), 0.511, List.of(List.of(look(10.0, 2.6)), List.of()));

        assertThat(route.isMisjudgedForCells(15.0)).isTrue();
        assertThat(warning(route)).isEmpty();
        assertThat(new RouteNotes(inputs).notes(results(route, Map.of())))
                .anyMatch(note -> note.startsWith("Less exposed routes from the north cannot be ruled out"));
    }

    /** The search expects 95 % along the whole route, but nothing in time, and no look detects the drone at all. */
    @Test
    void explainsWhereTheSearchAndTheFlightDifferTooLate() {
        SectorRoute late = late(List.of(List.of(), List.of()), Map.of("slow", 0.0));
        SectorRoute some =
                late(List.of(List.of(look(29.0, 20.0)), List.of(), List.of(), List.of()), Map.of("slow", 0.3));

        assertThat(warning(late)).isEmpty();
        assertThat(new RouteNotes(inputs).notes(results(late, Map.of())))
                .contains(
                        "On the route from the north, 'search' and 'detected' differ by more than 20 percentage points, but"
                                + " only by detections that come too late: the search knows only the middle of each cell.");
        assertThat(new RouteNotes(inputs).notes(results(some, Map.of())))
                .contains(
                        "On the route from the north, 'search' and 'detected' differ by more than 20 percentage points, but"
                                + " only by detections that come too late: the search assumes that 'slow' may look at any moment,"
                                + " whereas it looks only every 5 s.");
        SectorRoute alike = route(Map.of("slow", 3.0), 3.0, List.of(List.of(look(10.0, 3.0))));
        assertThat(new RouteNotes(inputs).notes(results(alike, Map.of()))).noneMatch(note -> note.contains("too late"));
    }

    /** A route on which the search expects no exposure that counts, but one of 3 after that. */
    private static SectorRoute late(List<List<FlownExposure.Step>> flown, Map<String, Double> bySensor) {
        SectorRoute all = route(Map.of("slow", 3.0), 3.0, flown);
        return new SectorRoute(
                0,
                new WeakestRoute(all.route().path(), 0, 0, 30),
                all.searched(),
                all.bySensor(),
                Map.of(),
                Optional.of(new FlownExposure(flown, bySensor)));
    }

    private String warning(SectorRoute route) {
        return String.join(
                "\n", new RouteNotes(inputs).warnings(results(route, Map.of()).survey()));
    }

    /** What the profile draws meets the line of the critical detection point where the table says. */
    @Test
    void theProfileShowsTheProbabilitiesOfTheTable() {
        SectorRoute route =
                route(Map.of("slow", 2.0), 10.0, List.of(List.of(look(16.0, 2.0)), List.of(look(14.0, 2.0))));

        assertThat(route.detectionUntil(route.critical(15.0))).isEqualTo(route.inTime(15.0));
        assertThat(route.detectionUntil(13.9)).isZero();
        assertThat(route.detectionUntil(30.0)).isEqualTo(route.detection());
    }

    /** The radar sees the drone in one of two flights: what counts is the mean probability, not the mean exposure. */
    @Test
    void mapsStateTheProbabilitiesOfTheTable() {
        SectorRoute route = route(Map.of("slow", 1.0), 10.0, List.of(List.of(look(16.0, 20.0)), List.of()));
        List<RouteMap.Piece> pieces = RoutePieces.of(results(route, Map.of()).survey());

        assertThat(pieces.get(pieces.size() - 1).detection()).isEqualTo(route.detection());
        assertThat(route.detection()).isCloseTo(0.5, within(1e-6));
    }
}
