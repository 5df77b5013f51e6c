package org.dronewatch.route;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.proof.ProvenChance;
import org.dronewatch.route.proof.RouteProof;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Draws;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.statistics.Proportion;
import org.junit.jupiter.api.AfterAll;
import org.junit.jupiter.api.TestInstance;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Weakest routes and random flights of real scenes, flown with many seeds: the predictions of detections, and of
 * alerts in time, lie in Wilson's 99 % intervals, but for three in a hundred, and all of them, with their own errors,
 * in exact intervals that are so wide that only one in a million lies outside by chance; in the short form, in
 * Wilson's intervals or the exact ones. Of 1,000 runs, 50 are repeated as plain runs, whose first detection and alert
 * must be the same. In the long form, {@code -Ddronewatch.sites=meadow,glider} chooses scenes. Each flight is a line
 * as soon as it is done.
 */
@TestInstance(TestInstance.Lifecycle.PER_CLASS)
class PackagedRouteTest {
    /** By name; all if empty. */
    private static final List<String> CHOSEN = Stream.of(
                    System.getProperty("dronewatch.sites", "").split(","))
            .filter(name -> !name.isEmpty())
            .toList();

    /** The confidence of the exact intervals outside which not one of a thousand predictions should lie by chance. */
    private static final double SURELY = 1.0 - 1e-6;

    private static final int RANDOM = LongForm.count(2, 20);
    private static final int RUNS = LongForm.count(40, 1000);

    /** Flights past a microphone whose looks take long. */
    private static final int HEARD = 3;

    /** Runs of each weakest route with all cues, in the long form. */
    private static final int CUED = 100;

    // The short form has a fixed seed: by chance, one in a hundred lies outside.
    private final long seed = LongForm.seed(8);

    /** Predictions outside Wilson's interval; in the short form, outside the exact one, too. */
    private final List<String> outside = new ArrayList<>();

    private int all;
    private int undecided;

    /** Predictions outside Wilson's interval but inside the exact one: less than one detection is expected. */
    private int rare;

    static List<FlownSite> sites() {
        if (!LongForm.IS_ON) {
            return List.of(FlownSite.SHORT);
        }
        assertThat(Stream.of(FlownSite.LONG, FlownSite.HEARD)
                        .flatMap(List::stream)
                        .map(FlownSite::name))
                .containsAll(CHOSEN);
        return FlownSite.LONG.stream().filter(PackagedRouteTest::isChosen).toList();
    }

    private static boolean isChosen(FlownSite site) {
        return CHOSEN.isEmpty() || CHOSEN.contains(site.name());
    }

    private static void say(String line, Object... values) {
        System.out.println("PackagedRouteTest: " + String.format(Locale.ROOT, line, values));
        System.out.flush();
    }

    private static double since(long begun) {
        return (System.nanoTime() - begun) / 1e9;
    }

    @ParameterizedTest(name = "{0}", allowZeroInvocations = true)
    @MethodSource("sites")
    void runsDetectAsOftenAsPredicted(FlownSite site) {
        say("%s, seed %d", site, seed);
        try (Workers workers = new Workers(2)) {
            workers.call(() -> compare(site));
        }
    }

    private boolean compare(FlownSite site) {
        long begun = System.nanoTime();
        PackagedFlights flights = new PackagedFlights(site);
        say("%s: field in %.1f s", site, since(begun));
        begun = System.nanoTime();
        List<SceneSettings> weakest = flights.weakest(LongForm.count(1, SiteRoutes.SECTORS));
        say("%s: %d weakest routes in %.1f s", site, weakest.size(), since(begun));
        for (int i = 0; i < weakest.size(); i++) {
            RouteProof proof = prove(site + ", weakest route " + (i + 1), weakest.get(i), flights);
            if (LongForm.IS_ON && RouteProof.hasCues(weakest.get(i))) {
                sayWithCues(weakest.get(i), flights, proof);
            }
        }
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < RANDOM; i++) {
            SceneSettings flight = flights.random(random, i % 2 == 0);
            prove(site + ", random flight " + (i + 1), flight, flights);
        }
        return true;
    }

    static List<FlownSite> heard() {
        return LongForm.IS_ON
                ? FlownSite.HEARD.stream().filter(PackagedRouteTest::isChosen).toList()
                : List.of();
    }

    /** Few flights, which may take minutes each. By its level, the drone is detected at a place or is not. */
    @ParameterizedTest(name = "{0}", allowZeroInvocations = true)
    @MethodSource("heard")
    void soDoRunsPastAMicrophone(FlownSite site) {
        say("%s, seed %d", site, seed);
        try (Workers workers = new Workers(2)) {
            workers.call(() -> {
                PackagedFlights flights = new PackagedFlights(site);
                SplittableRandom random = new SplittableRandom(seed);
                for (int i = 0; i < HEARD; i++) {
                    prove(site + ", random flight " + (i + 1), flights.random(random, false), flights);
                }
                return true;
            });
        }
    }

    /**
     * Each flight has other seeds, so that it differs from its prediction independently of the others. Number 0 would
     * be the given seed for all of them.
     */
    private RouteProof prove(String flight, SceneSettings site, PackagedFlights flights) {
        long begun = System.nanoTime();
        RunSettings run = site.run().withSeed(Draws.derivedSeed(seed, flight, 1));
        SceneSettings scene = SettingsForm.with(site, "run", run);
        RouteProof proof = RouteProof.of(scene, flights.models(), RUNS, done -> {});
        assertThat(proof.plain()).isEqualTo((RUNS + 19) / 20);
        compare(flight, proof.detection(), scene, begun);
        proof.alertInTime().ifPresent(alert -> compare(flight + ", alert in time", alert, scene, begun));
        return proof;
    }

    private void compare(String flight, ProvenChance proven, SceneSettings scene, long begun) {
        Proportion.Interval interval = proven.interval();
        boolean isUndecided = proven.predicted() > 0.01 && proven.predicted() < 0.99;
        all++;
        undecided += isUndecided ? 1 : 0;
        rare += proven.agrees() && !proven.isInInterval() ? 1 : 0;
        String figures = String.format(
                Locale.ROOT,
                "%s: predicted %.3f %%, occurred in %d of %d runs, %.3f to %.3f %%",
                flight,
                100.0 * proven.predicted(),
                proven.flown().count(),
                RUNS,
                100.0 * interval.low(),
                100.0 * interval.high());
        say(
                "%s; %s; %.1f s",
                figures,
                proven.isInInterval() ? "agrees" : proven.agrees() ? "outside Wilson's interval only" : "OUTSIDE",
                since(begun));
        assertThat(proven.isPlausible(SURELY)).as(figures).isTrue();
        // Of a few runs, Wilson's interval is too narrow.
        if (LongForm.IS_ON ? !proven.isInInterval() : !proven.agrees()) {
            outside.add(figures + ", " + scene.individualDrones().values());
        }
    }

    /** What cues make of it is no part of the prediction. */
    private static void sayWithCues(SceneSettings scene, PackagedFlights flights, RouteProof proof) {
        Proportion cued = RouteProof.withCues(scene, flights.models(), CUED, done -> {});
        say(
                "    with all cues, %d of %d runs detect it: %+.1f points",
                cued.count(), CUED, 100.0 * (cued.share() - proof.predicted()));
    }

    /** Of the sites that have run. Of a single one, all flights may be certain. */
    @AfterAll
    void predictionsAreInTheIntervals() {
        say(
                "%d predictions, %d of them left to chance, %d outside, %d outside Wilson's interval only",
                all, undecided, outside.size(), rare);
        assertThat(undecided).isGreaterThanOrEqualTo(CHOSEN.isEmpty() ? all / 5 : 0);
        assertThat(outside).as("of %d, seed %d", all, seed).hasSizeLessThanOrEqualTo(all * 3 / 100);
    }
}
