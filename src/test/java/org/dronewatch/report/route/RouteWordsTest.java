package org.dronewatch.report.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldSite;
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

    private static SectorRoute withAlert(SectorRoute route, double inTime) {
        return route.with(route.flown().orElseThrow().withAlertInTime(OptionalDouble.of(inTime)));
    }

    private RouteResults results(SectorRoute route) {
        return results(List.of(route));
    }

    private RouteResults results(List<SectorRoute> routes) {
        RouteSurvey survey = new RouteSurvey(
                routes, List.of(new RouteMode("powered", 10, 3, 3, Double.POSITIVE_INFINITY)), END, 15.0, true);
        TimeToGo times = null;
        return new RouteResults(survey, routes, new UnseenPlaces(4000, 0), times, Map.of(), true);
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
        String verdict = new RouteWords(inputs).weakest(results(withAlert(route, 0.3)));

        assertThat(verdict)
                .contains("the drone is detected, by b (44 %) and a (30 %), with a probability of ")
                .contains(
                        "The drone is detected in time with a probability of 39 % if flight and response take exactly as"
                                + " long as planned; if their times vary by 30 %, an alert comes in time with a probability of"
                                + " 30 %.");
        three.put("b", 0.60);
        assertThat(new RouteWords(inputs)
                        .weakest(results(
                                route(three, 1.0, route.flown().orElseThrow().flights()))))
                .contains("is detected, mostly by b, with a probability of ")
                .contains(". The drone is detected in time with a probability of 39 %.");
    }

    @Test
    void aNoteStatesFromWhereNoRouteLeads() {
        RouteResults results = results(route(Map.of("slow", 1.0), 1.0, List.of(List.of(look(10.0, 1.0)))));

        assertThat(new RouteNotes(inputs).notes(results))
                .anyMatch(note -> note.startsWith("There is no route from the north-east, east, south-east, south, "));
        RouteInputs launched = new RouteInputs(
                inputs.scene(),
                inputs.drone(),
                inputs.settings(),
                inputs.protection(),
                inputs.grid(),
                inputs.pointing(),
                Optional.of("{centre: [0, 300], radius: 10}"),
                Optional.empty());
        assertThat(new RouteNotes(launched).notes(results)).noneMatch(note -> note.startsWith("There is no route"));
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
        ProvenChance detection = new ProvenChance(0.6, 0.0, new Proportion(31, 50));
        ProvenChance alert = new ProvenChance(0.4, 0.0, new Proportion(9, 50));
        RouteProof proof = new RouteProof(detection, Map.of("slow", 0.6), Optional.of(alert), 3, Optional.empty());
        RouteResults results = results(route);
        RouteResults without = new RouteResults(
                results.survey(), results.found(), results.between(), results.times(), Map.of(0, proof), true);
        RouteResults with = new RouteResults(
                results.survey(),
                results.found(),
                results.between(),
                results.times(),
                Map.of(0, proof.with(new Proportion(33, 50))),
                true);

        assertThat(RouteTable.lines(without, inputs)).noneMatch(line -> line.contains("with cues"));
        assertThat(RouteTable.lines(with, inputs))
                .anyMatch(line -> line.endsWith("agrees     with cues"))
                .anyMatch(line -> line.contains("31 of 50") && line.endsWith("33 of 50"))
                .anyMatch(line -> line.contains("9 of 50") && line.endsWith("no"))
                .noneMatch(line -> line.startsWith("With cues"));
        RouteResults more = new RouteResults(
                results.survey(),
                results.found(),
                results.between(),
                results.times(),
                Map.of(0, proof.with(new Proportion(50, 50))),
                true);
        assertThat(RouteTable.lines(more, inputs))
                .contains("With cues, the drone is detected on the route from the north in 50 of 50 flights"
                        + " instead of the predicted 60 %.");
    }

    /** The route lists 63 % with sensors on positioners that count as cued; no prediction of flights knows these. */
    @Test
    void flightsWithCuesAreComparedWithWhatIsListedForCuedSensors() throws IOException {
        FieldSite mounted = FieldSite.in(
                directory,
                "  slow: {kind: camera, position: [0, 0, 4], aim: {azimuth: 0 deg}, positioner: {use: viper}}\n");
        RouteInputs cued = new RouteInputs(
                "site",
                FieldSite.DRONE,
                mounted.settings(),
                inputs.protection(),
                inputs.grid(),
                FieldTerms.Turning.CUED,
                Optional.empty(),
                Optional.empty());
        RouteResults kept = results(route(Map.of("slow", 1.0), 1.0, List.of(List.of(look(10.0, 1.0)))));
        ProvenChance searching = new ProvenChance(0.1, 0.0, new Proportion(5, 50));
        RouteProof proof = new RouteProof(searching, Map.of("slow", 0.1), Optional.empty(), 3, Optional.empty());
        RouteResults few = proven(kept, proof.with(new Proportion(6, 50)));
        RouteResults enough = proven(kept, proof.with(new Proportion(31, 50)));

        assertThat(new RouteNotes(cued).notes(few))
                .contains("With cues, the drone is detected on the route from the north in 6 of 50 flights"
                        + " instead of the listed 63 %.")
                .anyMatch(note -> note.endsWith("for which positioners count as cued."));
        assertThat(new RouteNotes(cued).notes(enough)).noneMatch(note -> note.startsWith("With cues"));
        assertThat(new RouteNotes(cued).notes(kept)).noneMatch(note -> note.endsWith("count as cued."));
    }

    private static RouteResults proven(RouteResults kept, RouteProof proof) {
        return new RouteResults(
                kept.survey(), kept.found(), kept.between(), kept.times(), Map.of(0, proof), kept.isComplete());
    }

    /** Half of the flights are surely detected in time, and half of them surely not. */
    @Test
    void namesTheScanWhereItIsTheCause() {
        SectorRoute scan =
                route(Map.of("slow", 20.0), 10.0, List.of(List.of(look(14.0, 20.0)), List.of(look(16.0, 20.0))));
        SectorRoute cells = route(Map.of("slow", 20.0), 0.0, List.of(List.of(look(14.0, 20.0))));
        SectorRoute both = route(Map.of("slow", 0.5), 3.0, List.of(List.of(look(14.0, 2.4)), List.of(), List.of()));

        assertThat(scan.inTime(15.0)).isCloseTo(0.5, within(1e-6));
        assertThat(warning(scan))
                .contains(
                        "because the search assumes that 'slow' may look at any moment, whereas it looks only every 5 s,"
                                + " which smaller cells do not change; less exposed routes, which cannot be ruled out, may be found"
                                + " between the middles of cells with --cell 10m; to look for them less than 30 m above the ground,"
                                + " add lower --heights");
        assertThat(warning(cells))
                .endsWith(
                        "because the search knows only the middle of each cell; try --cell 10m, which may also show less"
                                + " exposed routes: they cannot be ruled out; to look for them less than 30 m above the ground,"
                                + " add lower --heights");
        assertThat(warning(both))
                .contains(
                        "because the search knows only the middle of each cell, and assumes that 'slow' may look at any"
                                + " moment, whereas it looks only every 5 s; try --cell 10m, which");
    }

    /** The lower bound is 1.2, so that no route is detected with less than 70 %. */
    @Test
    void doesNotOfferLessExposedRoutesWhereThereAreNone() {
        SectorRoute scan = bounded(
                route(Map.of("slow", 20.0), 20.0, List.of(List.of(look(14.0, 40.0)), List.of(look(16.0, 40.0)))));
        SectorRoute cells = bounded(route(Map.of("slow", 0.5), 20.0, List.of(List.of(look(14.0, 0.5)))));

        assertThat(warning(scan)).endsWith("whereas it looks only every 5 s");
        assertThat(warning(cells)).endsWith("because the search knows only the middle of each cell; try --cell 10m");
    }

    private static SectorRoute bounded(SectorRoute route) {
        WeakestRoute least = route.route();
        return new SectorRoute(
                0,
                new WeakestRoute(least.path(), least.exposure(), 1.2, least.seconds()),
                route.searched(),
                route.bySensor(),
                route.causes(),
                route.flown());
    }

    /** Of three routes, the search misjudges two for different reasons, and the third may have a less exposed one. */
    @Test
    void eachDirectionIsNamedOnce() {
        SectorRoute scan =
                route(Map.of("slow", 20.0), 10.0, List.of(List.of(look(14.0, 20.0)), List.of(look(16.0, 20.0))));
        SectorRoute cells = from(2, route(Map.of("slow", 20.0), 0.0, List.of(List.of(look(14.0, 20.0)))));
        SectorRoute alike = from(4, route(Map.of("slow", 3.0), 3.0, List.of(List.of(look(10.0, 3.0)))));
        RouteResults results = results(List.of(scan, cells, alike));

        List<String> lines = RouteTable.summary(results, inputs);
        assertThat(lines.subList(1, lines.size()))
                .filteredOn(line -> line.contains("from the"))
                .satisfiesExactlyInAnyOrder(
                        line -> assertThat(line).contains("Less exposed routes from the south cannot be ruled out"),
                        line -> assertThat(line).startsWith("There is no route from the north-east, south-east, "),
                        line -> assertThat(line).contains("misjudges the route from the east:", "--cell 10m"),
                        line -> assertThat(line).contains("misjudges the route from the north:", "'slow'"));
    }

    private static SectorRoute from(int sector, SectorRoute route) {
        return new SectorRoute(
                sector, route.route(), route.searched(), route.bySensor(), route.causes(), route.flown());
    }

    /** A route is named that flights have replaced, unless one of those listed has the same exposure in print. */
    @Test
    void theRouteThatIsLeastExposedByTheSearchIsNamedIfItIsNotListed() {
        SectorRoute listed = route(Map.of("slow", 0.7004), 0.7004, List.of(List.of(look(10.0, 0.2))));
        SectorRoute replaced = route(Map.of("slow", 0.5), 0.5, List.of(List.of(look(10.0, 2.0))));
        SectorRoute alike = route(Map.of("slow", 0.6999), 0.6999, List.of(List.of(look(10.0, 2.0))));
        RouteResults kept = results(listed);
        String note =
                "By the search alone, the least exposed route comes from the north, with a counted exposure of 0.500"
                        + " (39 %). As flown, the drone is detected less often on the one listed from there.";

        assertThat(RouteTable.lines(with(kept, listed, replaced), inputs)).contains(note);
        assertThat(RouteFile.toJson(with(kept, listed, replaced), inputs)
                        .get("least_exposure")
                        .asDouble())
                .isEqualTo(0.5);
        assertThat(RouteTable.lines(with(kept, listed, alike), inputs))
                .noneMatch(line -> line.startsWith("By the search alone"));
        assertThat(RouteTable.lines(kept, inputs)).noneMatch(line -> line.startsWith("By the search alone"));
    }

    private static RouteResults with(RouteResults kept, SectorRoute... found) {
        return new RouteResults(kept.survey(), List.of(found), kept.between(), kept.times(), kept.proofs(), true);
    }

    /** What is rarer than one in a thousand is as wide as other numbers, so that it stays under its head. */
    @Test
    void smallNumbersDoNotMoveColumns() {
        SectorRoute route = route(Map.of("slow", 1e-6), 1e-6, List.of(List.of(look(10.0, 1e-6))));
        ProvenChance never = new ProvenChance(1e-6, 0.0, new Proportion(0, 100_000));
        RouteProof proof = new RouteProof(never, Map.of("slow", 1e-6), Optional.of(never), 3, Optional.empty());
        RouteResults found = results(withAlert(route, 1e-6));
        RouteResults results =
                new RouteResults(found.survey(), found.found(), found.between(), found.times(), Map.of(0, proof), true);
        List<String> lines = RouteTable.lines(results, inputs);

        assertThat(lines).noneMatch(line -> line.contains("less than 0.1 %"));
        assertUnder(lines, "alert in time", "< 0.1 %");
        assertUnder(lines, "search", "< 0.1 %");
        assertUnder(lines, "predicted", "< 0.1 %");
        assertUnder(lines, "agrees", "yes");
    }

    /** The next row that begins with the direction has a number that ends where the head of its column does. */
    private static void assertUnder(List<String> lines, String head, String number) {
        int at = 0;
        while (!lines.get(at).startsWith("from ") || !lines.get(at).contains(head)) {
            at++;
        }
        int end = lines.get(at).indexOf(head) + head.length();
        assertThat(lines.get(at + 1)).startsWith("north");
        assertThat(lines.get(at + 1).substring(0, end)).endsWith(" " + number);
    }

    /** Nobody is told to rely on a direction from which the drone arrives before the response does. */
    @Test
    void namesTheDirectionsFromWhichNothingIsInTime() {
        SectorRoute far = route(Map.of("slow", 1.0), 1.0, List.of(List.of(look(10.0, 1.0))));
        RouteProfile profile = new RouteProfile(
                List.of(new RoutePoint(0, 0, START, 30, 0, 0, true), new RoutePoint(10, 100, END, 30, 0, 1, true)));
        SectorRoute near = new SectorRoute(2, far.route(), profile, far.bySensor(), Map.of(), far.flown());
        RouteSurvey alone = results(far).survey();
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
        assertThat(warning(more))
                .contains("the middle of each cell; try --cell 10m")
                .doesNotContain("slow");
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

        assertThat(RouteTable.lines(results(route), inputs).get(1)).contains("  counted exposure  lower bound  ");
    }

    /** A descent above a radar is found in smaller cells, a route close to the ground only at lower heights. */
    @Test
    void whatMayBeFoundElsewhereIsLookedForInSmallerCellsAndLower() {
        SectorRoute route = route(Map.of("slow", 3.0), 3.0, List.of(List.of(look(10.0, 3.0))));
        RouteResults results = results(route);

        assertThat(new RouteWords(inputs).weakest(results))
                .endsWith(". Routes were searched for in cells of 20 m, 30 m above the ground.");
        assertThat(new RouteNotes(inputs).notes(results))
                .anyMatch(note -> note.startsWith("Less exposed routes from the north cannot be ruled out")
                        && note.contains("try --cell 10m")
                        && note.contains("less than 30 m above the ground, add lower --heights"))
                .containsOnlyOnce("Routes more than 30 m above the ground were not searched for, although the drone's"
                        + " ceiling is 500 m; to include them, add higher --heights.");
    }

    /** At 12 m/s, the first cell of 20 m takes 1.7 s: from farther away, the drone may come in another way. */
    @Test
    void aRouteThatBeginsWhereSensorsDetectMayBeginFartherAway() {
        SectorRoute route = route(Map.of("slow", 3.0), 3.0, List.of(List.of(look(10.0, 3.0))));
        String farther = "sensors detect the drone where a route begins: to let routes begin farther away, try a larger"
                + " --side.";

        RouteResults seen = results(from(route, 1.0));
        assertThat(new RouteNotes(inputs).notes(seen)).anyMatch(note -> note.endsWith(farther));
        assertThat(RouteFile.toJson(seen, inputs).get("notes").toString()).contains(farther);
        assertThat(new RouteNotes(inputs).notes(results(from(route, 5.0))))
                .anyMatch(note -> note.startsWith("Less exposed routes from the north cannot be ruled out"))
                .noneMatch(note -> note.contains("farther away"));
    }

    /** The route, exposed from some time on, s. */
    private static SectorRoute from(SectorRoute route, double time) {
        RouteProfile profile = new RouteProfile(List.of(
                new RoutePoint(0, 0, START, 30, 0, 0, true),
                new RoutePoint(time, 10.0 * time, new Position(0, 300.0 - 10.0 * time, 30), 30, 0, 0, true),
                new RoutePoint(30, 300, END, 30, 0, 3.0, true)));
        return new SectorRoute(0, route.route(), profile, Map.of(), Map.of(), route.flown());
    }

    /**
     * The search expects 47 %, looks at any moment would detect 58 %, slow ones detect 54 %: no warning says that less
     * exposed routes cannot be ruled out.
     */
    @Test
    void whatNoWarningSaysIsNoted() {
        SectorRoute route =
                route(Map.of("slow", 0.78), 0.635, List.of(List.of(look(10.0, 1.3)), List.of(look(10.0, 0.435))));

        assertThat(route.route().detection()).isCloseTo(0.47, within(0.005));
        assertThat(route.flown().orElseThrow().detectionByFastLooks(15.0)).isCloseTo(0.58, within(0.005));
        assertThat(route.inTime(15.0)).isCloseTo(0.54, within(0.005));
        assertThat(warning(route)).isEmpty();
        assertThat(new RouteNotes(inputs).notes(results(route)))
                .anyMatch(note -> note.startsWith("Less exposed routes from the north cannot be ruled out"));
    }

    /** The search expects 95 % along the whole route, but nothing in time, and no look detects the drone at all. */
    @Test
    void explainsWhereTheSearchAndTheFlightDifferTooLate() {
        SectorRoute late = late(List.of(List.of(), List.of()), Map.of("slow", 0.0));
        SectorRoute some =
                late(List.of(List.of(look(29.0, 20.0)), List.of(), List.of(), List.of()), Map.of("slow", 0.3));

        assertThat(warning(late)).isEmpty();
        assertThat(new RouteNotes(inputs).notes(results(late)))
                .contains(
                        "On the route from the north, 'search' and 'detected' differ by more than 20 percentage points, but"
                                + " only by detections that come too late: the search knows only the middle of each cell.");
        assertThat(new RouteNotes(inputs).notes(results(some)))
                .contains(
                        "On the route from the north, 'search' and 'detected' differ by more than 20 percentage points, but"
                                + " only by detections that come too late: the search assumes that 'slow' may look at any moment,"
                                + " whereas it looks only every 5 s.");
        SectorRoute alike = route(Map.of("slow", 3.0), 3.0, List.of(List.of(look(10.0, 3.0))));
        assertThat(new RouteNotes(inputs).notes(results(alike))).noneMatch(note -> note.contains("too late"));
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
        return String.join("\n", new RouteNotes(inputs).warnings(results(route).survey()));
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
        List<RouteMap.Piece> pieces = RoutePieces.of(results(route).survey());

        assertThat(pieces.get(pieces.size() - 1).detection()).isEqualTo(route.detection());
        assertThat(route.detection()).isCloseTo(0.5, within(1e-6));
    }
}
