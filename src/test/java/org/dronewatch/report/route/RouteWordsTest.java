package org.dronewatch.report.route;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.report.html.ReportPage;
import org.dronewatch.report.map.RouteMap;
import org.dronewatch.route.CauseTimes;
import org.dronewatch.route.RouteCauses;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.proof.ProvenChance;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.sensor.Cause;
import org.dronewatch.statistics.Proportion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.w3c.dom.Document;

/** What the table, the verdict and the pictures say of {@link RouteSamples}. */
class RouteWordsTest extends RouteSamples {
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

    /** The dominant cause is that of the sensor that comes nearest to a detection, and hides that of the other. */
    @Test
    void causesThatDifferAreStatedBySensor() throws IOException {
        CauseTimes weak = new CauseTimes(Map.of(Cause.TOO_WEAK, 30.0));
        Map<String, CauseTimes> bySensor = new LinkedHashMap<>();
        bySensor.put(
                "slow",
                new CauseTimes(Map.of(
                        Cause.OUT_OF_VIEW,
                        22.2,
                        Cause.TOO_SLOW,
                        5.7,
                        Cause.HIDDEN_BY_BUILDING,
                        1.8,
                        Cause.SILENT,
                        0.3)));
        bySensor.put("slower", weak);
        SectorRoute route = missed(weak, bySensor);
        RouteReasons reasons = new RouteReasons(inputs.settings());

        assertThat(reasons.inWords(route))
                .contains(
                        "slow: out of view 74 % of the time, too slow 19 %, hidden by a building 6 %; slower: echo too"
                                + " weak all the time");
        assertThat(new RouteWords(inputs).weakest(results(route)))
                .contains(
                        "30 m above the ground (slow: out of view 74 % of the time; slower: echo too weak all the time):"
                                + " no sensor detects it on the way");
        ByteArrayOutputStream page = new ByteArrayOutputStream();
        new RouteReport(results(route), inputs, site.stage()).write(page, List.of(), Map.of());
        Document report = ReportPage.parsed(page.toString(StandardCharsets.UTF_8));
        assertThat(ReportPage.texts(report, "th")).containsSubsequence("most exposed to", "reason for misses");
        assertThat(ReportPage.texts(report, "td"))
                .containsSubsequence("no sensor", reasons.inWords(route).orElseThrow());
    }

    @Test
    void aCauseThatAllSensorsShareIsStatedOnce() {
        CauseTimes weak = new CauseTimes(Map.of(Cause.TOO_WEAK, 20.0, Cause.DETECTED, 10.0));
        RouteReasons reasons = new RouteReasons(inputs.settings());

        assertThat(reasons.inWords(missed(weak, Map.of("slow", weak, "slower", weak))))
                .contains("too small, faint or quiet for the sensors most of the time");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "TOO_WEAK | 0 | too small, faint or quiet for the sensors all the time",
                "TOO_WEAK | 20 | too small, faint or quiet for the sensors part of the time",
                "SILENT | 0 | emitting nothing that the sensors can detect",
                "SILENT | 5 | mostly emitting nothing that the sensors can detect",
                "SILENT | 20 | part of the time emitting nothing that the sensors can detect",
            })
    void howOftenACauseAppliesIsStated(Cause cause, double detected, String words) {
        CauseTimes times =
                new CauseTimes(detected == 0.0 ? Map.of(cause, 10.0) : Map.of(cause, 10.0, Cause.DETECTED, detected));

        assertThat(new RouteReasons(inputs.settings()).inWords(missed(times, Map.of("slow", times, "slower", times))))
                .contains(words);
    }

    @Test
    void manySensorsAreCountedByTheirMainCause() {
        CauseTimes hidden = new CauseTimes(Map.of(Cause.HIDDEN_BY_BUILDING, 20.0, Cause.OUT_OF_VIEW, 10.0));
        Map<String, CauseTimes> bySensor = new LinkedHashMap<>();
        // In another order than that of their names, which counts.
        bySensor.put("far", new CauseTimes(Map.of(Cause.OUT_OF_RANGE, 30.0)));
        for (int i = 1; i <= 5; i++) {
            bySensor.put("camera-" + i, hidden);
        }

        assertThat(new RouteReasons(inputs.settings()).inWords(missed(hidden, bySensor)))
                .contains("5 sensors: mainly hidden by a building; far: mainly out of range");
    }

    /** What a sensor misses for a moment only is no reason, and does not replace what all sensors share. */
    @ParameterizedTest
    @ValueSource(ints = {1, 5})
    void aSensorThatHardlyMissesTheDroneIsLeftOut(int others) {
        CauseTimes weak = new CauseTimes(Map.of(Cause.TOO_WEAK, 20.0, Cause.DETECTED, 10.0));
        Map<String, CauseTimes> bySensor = new LinkedHashMap<>();
        for (int i = 0; i < others; i++) {
            bySensor.put("slow" + (i == 0 ? "" : i), weak);
        }
        bySensor.put("slower", new CauseTimes(Map.of(Cause.DETECTED, 28.8, Cause.OUT_OF_VIEW, 1.2)));
        RouteReasons reasons = new RouteReasons(inputs.settings());

        assertThat(reasons.inWords(missed(weak, bySensor)))
                .contains("too small, faint or quiet for the sensors most of the time");
    }

    @Test
    void aCauseThatAppliesForAShortTimeIsNotTheMainOne() {
        CauseTimes hidden = new CauseTimes(Map.of(Cause.HIDDEN_BY_BUILDING, 30.0));
        Map<String, CauseTimes> bySensor = new LinkedHashMap<>();
        for (int i = 1; i <= 5; i++) {
            bySensor.put("camera-" + i, hidden);
        }
        bySensor.put("slower", new CauseTimes(Map.of(Cause.DETECTED, 28.5, Cause.OUT_OF_VIEW, 1.5)));

        assertThat(new RouteReasons(inputs.settings()).inWords(missed(hidden, bySensor)))
                .contains("5 sensors: mainly hidden by a building; slower: partly out of view");
    }

    /** A route on which nothing detects the drone. */
    private static SectorRoute missed(CauseTimes dominant, Map<String, CauseTimes> bySensor) {
        SectorRoute route = route(Map.of("slow", 0.0), 0.0, List.of(List.of()));
        return new SectorRoute(
                0,
                route.route(),
                route.searched(),
                route.bySensor(),
                new RouteCauses(dominant, bySensor),
                route.flown());
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
        RouteResults without = proven(results, proof);
        RouteResults with = proven(results, proof.with(new Proportion(33, 50)));

        assertThat(RouteTable.lines(without, inputs)).noneMatch(line -> line.contains("with cues"));
        assertThat(RouteTable.lines(with, inputs))
                .anyMatch(line -> line.endsWith("agrees     with cues"))
                .anyMatch(line -> line.contains("31 of 50") && line.endsWith("33 of 50"))
                .anyMatch(line -> line.contains("9 of 50") && line.endsWith("no"))
                .noneMatch(line -> line.startsWith("With cues"));
        RouteResults more = proven(results, proof.with(new Proportion(50, 50)));
        assertThat(RouteTable.lines(more, inputs))
                .contains("With cues, the drone is detected on the route from the north in 50 of 50 flights"
                        + " instead of the predicted 60 %.");
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
                        + " (detected in time with a probability of 39 %). The table lists another route from the north"
                        + " instead: as flown, the drone is detected less often on that one.";

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
        RouteResults results = proven(results(withAlert(route, 1e-6)), proof);
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

    @Test
    void theTableTellsTheExposureThatCountsFromThatOfTheWholeRoute() {
        SectorRoute route = route(Map.of("slow", 1.0), 1.0, List.of(List.of(look(10.0, 1.0))));

        assertThat(RouteTable.lines(results(route), inputs).get(1)).contains("  counted exposure  lower bound  ");
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
