package org.dronewatch.report.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.geometry.Position;
import org.dronewatch.route.FlownExposure;
import org.dronewatch.route.RouteCauses;
import org.dronewatch.route.RoutePoint;
import org.dronewatch.route.RouteProfile;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.ProvenChance;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.route.search.WeakestRoute;
import org.dronewatch.statistics.Proportion;
import org.junit.jupiter.api.Test;

/** What notes and warnings say of {@link RouteSamples}. */
class RouteNotesTest extends RouteSamples {
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
                .anyMatch(note -> note.endsWith("which assume that positioners are cued."));
        assertThat(new RouteNotes(cued).notes(enough)).noneMatch(note -> note.startsWith("With cues"));
        assertThat(new RouteNotes(cued).notes(kept)).noneMatch(note -> note.endsWith("count as cued."));
    }

    /** Half of the flights are certain to be detected in time, and half of them are certain not to be. */
    @Test
    void namesTheScanWhereItIsTheCause() {
        SectorRoute scan =
                route(Map.of("slow", 20.0), 10.0, List.of(List.of(look(14.0, 20.0)), List.of(look(16.0, 20.0))));
        SectorRoute cells = route(Map.of("slow", 20.0), 0.0, List.of(List.of(look(14.0, 20.0))));
        SectorRoute both = route(Map.of("slow", 0.5), 3.0, List.of(List.of(look(14.0, 2.4)), List.of(), List.of()));

        assertThat(scan.inTime(15.0)).isCloseTo(0.5, within(1e-6));
        assertThat(warning(scan))
                .contains(
                        "because the search assumes that 'slow' may look at any moment, whereas it looks only every 5 s;"
                                + " smaller cells do not remove this error, but less exposed routes cannot be ruled out: to look for"
                                + " them between cell centres, try --cell 10m; to look for them less than 30 m above the ground,"
                                + " add lower --heights");
        assertThat(warning(cells))
                .endsWith(
                        "because the search assesses each cell only at its centre; try --cell 10m, which may also show less"
                                + " exposed routes: they cannot be ruled out; to look for them less than 30 m above the ground,"
                                + " add lower --heights");
        assertThat(warning(both))
                .contains(
                        "because the search assesses each cell only at its centre, and assumes that 'slow' may look at any"
                                + " moment, whereas it looks only every 5 s; try --cell 10m, which");
    }

    /** The lower bound is 1.2, so that no route is detected with less than 70 %. */
    @Test
    void doesNotOfferLessExposedRoutesWhereThereAreNone() {
        SectorRoute scan = bounded(
                route(Map.of("slow", 20.0), 20.0, List.of(List.of(look(14.0, 40.0)), List.of(look(16.0, 40.0)))));
        SectorRoute cells = bounded(route(Map.of("slow", 0.5), 20.0, List.of(List.of(look(14.0, 0.5)))));

        assertThat(warning(scan)).endsWith("whereas it looks only every 5 s");
        assertThat(warning(cells)).endsWith("because the search assesses each cell only at its centre; try --cell 10m");
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

    /** Nobody is told to rely on a direction from which the drone arrives before the response does. */
    @Test
    void namesTheDirectionsFromWhichNothingIsInTime() {
        SectorRoute far = route(Map.of("slow", 1.0), 1.0, List.of(List.of(look(10.0, 1.0))));
        RouteProfile profile = new RouteProfile(
                List.of(new RoutePoint(0, 0, START, 30, 0, 0, true), new RoutePoint(10, 100, END, 30, 0, 1, true)));
        SectorRoute near = new SectorRoute(2, far.route(), profile, far.bySensor(), RouteCauses.NONE, far.flown());
        RouteSurvey alone = results(far).survey();
        RouteSurvey both = new RouteSurvey(List.of(far, near), alone.modes(), END, 15.0, true);
        RouteSurvey nearAlone = new RouteSurvey(List.of(near), alone.modes(), END, 15.0, true);

        assertThat(warning(far)).doesNotContain("no detection");
        assertThat(new RouteNotes(inputs).warnings(both).get(0))
                .contains("no detection can be in time on the route from the east, which takes 10 s, whereas the"
                        + " response takes 15 s");
        assertThat(new RouteNotes(inputs).warnings(nearAlone).get(0))
                .contains("no detection can be in time, because the route takes 10 s, whereas the response takes 15 s");
    }

    /** Slow looks detect less than the search expects, so that they are no reason why it expects nothing. */
    @Test
    void doesNotNameTheScanWhereMoreIsDetectedThanExpected() {
        SectorRoute more =
                route(Map.of("slow", 20.0), 0.0, List.of(List.of(look(14.0, 20.0)), List.of(look(16.0, 20.0))));

        assertThat(more.inTime(15.0)).isCloseTo(0.5, within(1e-6));
        assertThat(warning(more)).contains("only at its centre; try --cell 10m").doesNotContain("slow");
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

    /** The search takes the drone to be certain of detection by one of two slow sensors, whose looks all miss it. */
    @Test
    void namesASensorThatMissesWhatTheSearchExpects() {
        Map<String, Double> looks = new LinkedHashMap<>();
        looks.put("slow", 0.7);
        looks.put("slower", 1e-3);
        Map<String, Double> searched = Map.of("slow", 0.7, "slower", 9.0);
        SectorRoute flown = route(looks, 10.0, List.of(List.of(look(14.0, 20.0)), List.of(look(16.0, 20.0))));
        SectorRoute route =
                new SectorRoute(0, flown.route(), flown.searched(), searched, RouteCauses.NONE, flown.flown());

        assertThat(warning(route)).contains("'slower' may look at any moment, whereas it looks only every 20 s");
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
        return new SectorRoute(0, route.route(), profile, Map.of(), RouteCauses.NONE, route.flown());
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
                                + " only because of detections that come too late: the search assesses each cell only at its centre.");
        assertThat(new RouteNotes(inputs).notes(results(some)))
                .contains(
                        "On the route from the north, 'search' and 'detected' differ by more than 20 percentage points, but"
                                + " only because of detections that come too late: the search assumes that 'slow' may look at any moment,"
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
                RouteCauses.NONE,
                Optional.of(new FlownExposure(flown, bySensor)));
    }

    private String warning(SectorRoute route) {
        return String.join("\n", new RouteNotes(inputs).warnings(results(route).survey()));
    }
}
