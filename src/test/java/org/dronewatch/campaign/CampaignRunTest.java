package org.dronewatch.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.campaign.outcome.PairedDifference;
import org.dronewatch.campaign.outcome.VariantComparison;
import org.dronewatch.campaign.outcome.VariantSummary;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.RunResult;
import org.dronewatch.run.RunSession;
import org.dronewatch.sensor.Observation;
import org.dronewatch.setting.InputException;
import org.dronewatch.statistics.Proportion;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class CampaignRunTest {
    @TempDir
    private static Path directory;

    private static CampaignPlan plan;
    private static List<CaseResult> results;

    @BeforeAll
    static void run() throws IOException {
        plan = CampaignSite.plan(directory, CampaignSite.TWO_RANGES);
        results = results(plan, 2);
    }

    private static List<CaseResult> results(CampaignPlan campaign, int threads) {
        Map<Integer, List<CaseResult>> chunks = new TreeMap<>();
        CampaignRun.Chunks kept = new CampaignRun.Chunks() {
            @Override
            public Optional<List<CaseResult>> find(int chunk) {
                return Optional.empty();
            }

            @Override
            public void put(int chunk, List<CaseResult> made) {
                chunks.put(chunk, made);
            }
        };
        try (Workers workers = new Workers(threads)) {
            workers.call(() -> {
                new CampaignRun(campaign).run(kept, cases -> {});
                return null;
            });
        }
        List<CaseResult> all = new ArrayList<>();
        chunks.values().forEach(all::addAll);
        return all;
    }

    @Test
    void everyCaseIsRunWithEveryVariant() {
        assertThat(results).hasSize(120).noneMatch(CaseResult::isFailed);
        for (int i = 0; i < results.size(); i++) {
            assertThat(results.get(i).number()).isEqualTo(i / 2);
            assertThat(results.get(i).variant()).isEqualTo(i % 2 == 0 ? "near" : "far");
            assertThat(results.get(i).values()).isEqualTo(results.get(i / 2 * 2).values());
            assertThat(results.get(i).seed()).isEqualTo(results.get(i / 2 * 2).seed());
        }
        assertThat(results.stream().map(CaseResult::seed).distinct()).hasSize(60);
        assertThat(plan.seed(0)).isEqualTo(1L);
    }

    @Test
    void aCaseAloneIsThatOfTheCampaignForAnyNumberOfThreads() {
        assertThat(results(plan, 1)).isEqualTo(results);
        assertThat(CaseRun.of(plan, 57, "near")).isEqualTo(results.get(114));
    }

    /** What the window shows of a case is what the case gave: DSOL drives one, and a plain loop the other. */
    @Test
    void aCaseAsASceneGivesTheResultsOfTheCase() {
        for (String variant : plan.variants()) {
            CaseScene one = plan.scene(57, variant);
            RunResult run = one.runner().threads(2).run().runs().get(0);
            CaseResult kept = CaseRun.of(plan, 57, variant);

            assertThat(one.scene().name()).isEqualTo("site, case 57 (" + variant + ")");
            assertThat(run.alerts().get(0).time()).isEqualTo(kept.alert());
            assertThat(run.alerts().get(0).warning()).isEqualTo(kept.warning());
            assertThat(run.pairs().get(0).firstDetected()).isEqualTo(kept.firstDetected());
        }
    }

    /** A drone at 15 m/s takes 40 s for the 600 m; it then hovers 60 m above the middle of a zone of 30 m. */
    @Test
    void aRunThatEndsBeforeTheDroneArrivesIsCutShort() throws IOException {
        CampaignPlan blind = CampaignSite.plan(
                directory,
                """
                scene: site.yaml
                vary:
                  run.duration: {values: [20 s, 60 s]}
                variants:
                  blind: {sensors.radar.enabled: false}
                runs: 12
                """);
        CampaignSummary summary = new CampaignSummary(blind.variants());
        List<CaseResult> some = results(blind, 1);
        some.forEach(one -> summary.add(List.of(one)));

        assertThat(some).allSatisfy(one -> {
            boolean ends = one.values().get(0).equals("20 s");
            assertThat(one.cutShort()).isEqualTo(ends);
            assertThat(one.closest().orElseThrow()).isBetween(ends ? 250.0 : 30.0, ends ? 300.0 : 30.0);
        });
        assertThat(summary.variants().get("blind").cutShort()).isBetween(1, 11);
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
    }

    /** Whatever goes wrong in one case, the others have their results. */
    @Test
    void anUnexpectedErrorIsTheFailureOfItsCase() {
        AtomicInteger asked = new AtomicInteger();
        Cases broken = new Cases() {
            @Override
            public int size() {
                return 1;
            }

            @Override
            public List<String> variants() {
                return plan.variants();
            }

            @Override
            public List<String> values(int number) {
                return asked.getAndIncrement() == 0 ? plan.values(number) : List.of();
            }

            @Override
            public long seed(int number) {
                return plan.seed(number);
            }
        };

        CaseResult failed = CaseRun.of(plan, broken, 0, "near");

        assertThat(failed.isFailed()).isTrue();
        assertThat(failed.error().orElseThrow()).startsWith("internal error: ").contains("IndexOutOfBounds");
    }

    /** Cases draw their seeds from the campaign's; a value that another overrides would never be flown. */
    @Test
    void whatWouldBeOverriddenIsRefused() {
        refusedBeside(
                "vary: {run.seed: {values: [11, 12]}}",
                "2:18: vary: run.seed: cannot be set, because each case has its own");
        refusedBeside(
                "variants: {a: {run.seed: 5}}",
                "2:26: variants: a.run.seed: cannot be set, because each case has its own");
        refusedBeside(
                "vary: {drones.intruder.flight.target.x: {values: [1]}, drones.intruder.flight.target: {values: [a]}}",
                "vary: drones.intruder.flight.target: overlaps 'drones.intruder.flight.target.x', which varies as well");
    }

    private static void refusedBeside(String lines, String message) {
        try {
            assertThatThrownBy(() -> CampaignSite.plan(directory, "scene: site.yaml\n" + lines + "\n"))
                    .isInstanceOf(InputException.class)
                    .message()
                    .contains("attacks.campaign.yaml:", message)
                    .doesNotContain("\n");
            CampaignSite.in(directory, CampaignSite.TWO_RANGES);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Test
    void aCaseDependsNeitherOnTheirNumberNorOnWhatElseVaries() throws IOException {
        CampaignPlan other = CampaignSite.plan(
                directory,
                """
                scene: site.yaml
                vary:
                  drones.intruder.speed: {values: [10 m/s, 20 m/s]}
                  run.duration: {uniform: {from: 10 s, to: 20 s}}
                runs: 3
                """);

        assertThat(other.variants()).containsExactly("scene");
        for (int number = 0; number < 100; number++) {
            assertThat(other.values(number).get(0))
                    .isEqualTo(plan.values(number).get(2));
            assertThat(other.seed(number)).isEqualTo(plan.seed(number));
        }
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
    }

    @Test
    void theVariantThatSeesFartherIsNeverWorse() {
        CampaignSummary summary = new CampaignSummary(plan.variants());
        for (int i = 0; i < results.size(); i += 2) {
            summary.add(results.subList(i, i + 2));
        }
        VariantComparison inTime = summary.comparisons().stream()
                .filter(pair -> pair.outcome() == Outcome.IN_TIME)
                .findFirst()
                .orElseThrow();

        assertThat(inTime.difference().onlyA()).isZero();
        assertThat(inTime.difference().onlyB()).isPositive().isLessThan(60);
        assertThat(inTime.deciding()).isSorted().hasSizeBetween(1, 20);
        VariantSummary near = summary.variants().get("near");
        assertThat(near.cases()).isEqualTo(60);
        assertThat(near.ranges().quantile(1.0).orElseThrow()).isLessThanOrEqualTo(350.0);
        // Sectors of 45 deg: bearings of -60 to 60 deg begin in the three about north.
        assertThat(near.proportion(Outcome.DETECTED, 4)).isEmpty();
        assertThat(near.proportion(Outcome.DETECTED, 0).orElseThrow().of()
                        + near.proportion(Outcome.DETECTED, 1).orElseThrow().of()
                        + near.proportion(Outcome.DETECTED, 7).orElseThrow().of())
                .isEqualTo(60);
    }

    @Test
    void identicalVariantsDoNotDifferInAnyCase() throws IOException {
        CampaignPlan same = CampaignSite.plan(
                directory,
                """
                scene: site.yaml
                vary:
                  drones.intruder.flight.distance: {uniform: {from: 300 m, to: 400 m}}
                variants:
                  one: {}
                  other: {alert.response: 12 s}
                runs: 30
                """);
        List<CaseResult> both = results(same, 2);
        CampaignSummary summary = new CampaignSummary(same.variants());
        for (int i = 0; i < both.size(); i += 2) {
            summary.add(both.subList(i, i + 2));
        }

        assertThat(summary.comparisons()).hasSize(3).allSatisfy(pair -> {
            assertThat(pair.difference()).isEqualTo(new PairedDifference(0, 0, 30));
            assertThat(pair.deciding()).isEmpty();
        });
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
    }

    /** Writes the site with a second drone or sensor, which ends a section, as pair.yaml. */
    private void addToPair(String second, String nextSection) throws IOException {
        String site = Files.readString(directory.resolve("site.yaml"));
        Files.writeString(directory.resolve("pair.yaml"), site.replace(nextSection, second + nextSection));
    }

    /** The second drone comes from behind the radar. */
    @Test
    void everyAttackingDroneIsCountedApart() throws IOException {
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
        String second = "  second: {model: packaged:quadrotor.obj, speed: 15 m/s, radar: {droneClass: small-uav},"
                + " flight: {kind: inbound, target: [0, 0, 20], bearing: 180 deg, height: 40 m, distance: 600 m}}\n";
        addToPair(second, "sensors:");
        CampaignPlan pair = CampaignSite.plan(
                directory,
                """
                scene: pair.yaml
                vary:
                  drones.intruder.flight.distance: {values: [200 m, 500 m]}
                runs: 10
                """);
        CampaignSummary summary = new CampaignSummary(pair.variants());
        results(pair, 1).forEach(result -> summary.add(List.of(result)));
        VariantSummary scene = summary.variants().get("scene");

        assertThat(scene.drones()).containsExactly("intruder", "second");
        assertThat(scene.proportion(Outcome.DETECTED, "second")).contains(new Proportion(0, 10));
        assertThat(scene.proportion(Outcome.DETECTED, "intruder")).isEqualTo(scene.proportion(Outcome.DETECTED));
        assertThat(scene.proportion(Outcome.IN_TIME, "intruder")).isEqualTo(scene.proportion(Outcome.IN_TIME));
        assertThat(scene.proportion(Outcome.IN_TIME, "intruder").orElseThrow().count())
                .isBetween(1, 9);
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
    }

    /** The second radar draws the same numbers whether the first one has a shorter range, or is switched off. */
    @Test
    void sensorsThatLayoutsHaveInCommonDrawTheSameNumbers() throws IOException {
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
        String second = "  second: {use: spotterrf-c550ext, position: [50, 0, 10],"
                + " aim: {azimuth: 10 deg, elevation: 0 deg}}\n";
        addToPair(second, "alert:");
        CampaignPlan pair = CampaignSite.plan(
                directory,
                """
                scene: pair.yaml
                vary:
                  drones.intruder.flight.bearing: {uniform: {from: -60 deg, to: 60 deg}}
                variants:
                  both: {}
                  near: {sensors.radar.maxRange: 350 m}
                  off: {sensors.radar.enabled: false}
                runs: 8
                """);
        for (int number = 0; number < 8; number++) {
            List<Observation> both = observations(pair, number, "both");
            assertThat(observations(pair, number, "near")).isEqualTo(both);
            assertThat(observations(pair, number, "off")).isEqualTo(both);
        }
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
    }

    private static List<Observation> observations(CampaignPlan plan, int number, String variant) {
        List<Observation> observations = new ArrayList<>();
        try (RunSession session = new RunSession(
                plan.settings(number, variant),
                plan.seed(number),
                plan.variant(variant).models())) {
            while (session.nextTime().isPresent()) {
                session.advance().observations().stream()
                        .filter(one -> one.look().sensor().equals("second"))
                        .forEach(observations::add);
            }
        }
        assertThat(observations).isNotEmpty();
        return observations;
    }

    @Test
    void aCaseThatCannotBeRunHasItsRow() throws IOException {
        CampaignPlan odd = CampaignSite.plan(
                directory,
                """
                scene: site.yaml
                vary:
                  drones.intruder.flight.distance: {values: [300 m, 500 m]}
                  drones.intruder.flight.standoff: {values: [0 m, 400 m]}
                runs: 20
                """);
        List<CaseResult> some = results(odd, 1);

        assertThat(some).filteredOn(CaseResult::isFailed).isNotEmpty().allSatisfy(failed -> {
            assertThat(failed.values()).containsExactly("300 m", "400 m");
            assertThat(failed.error().orElseThrow()).contains("standoff").doesNotContain("\n");
        });
        assertThat(some).filteredOn(one -> !one.isFailed()).isNotEmpty();
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
    }

    @Test
    void whatCannotBeRunIsRefusedBeforeTheFirstCase() {
        refused("vary: {drones.intruder.sped: {values: [1 m/s]}}", "vary.drones.intruder.sped: ");
        refused("vary: {drones.intruder.speed: {uniform: {from: 5 m/s, to: 900 m/s}}}", "vary.drones.intruder.speed: ");
        refused(
                "vary: {drones.intruder.speed: {}}",
                "needs exactly one of values, range, uniform, normal and triangular");
        refused("vary: {drones.intruder.speed: {values: [5], uniform: {from: 5, to: 6}}}", "it has 2");
        refused("vary: {drones.intruder.speed: {range: {from: 5, to: 6}}}", "range needs either count or step");
        refused(
                "vary: {drones.intruder.speed: {range: {from: 5 m/s, to: 900 m/s, step: 5 m/s}}}",
                "vary.drones.intruder.speed: ");
        refused(
                "vary: {drones.intruder.speed: {values: [5]}}\nvariants: {a: {drones.intruder.speed: 5}}",
                "'drones.intruder.speed' would override 'drones.intruder.speed', which varies from case to case");
        refused("vary: {}\nvariants: {a: {sensors.radar: nothing}}", "nothing");
        refused(
                "vary: {}\nvariants: {a: {scene: ../else.yaml}}",
                "must lie in the directory of the campaign file or below it");
        refused("vary: {}\nvariants: {a: {scene: org.dronewatch.scenes.MultiSensor}}", "neither packaged");
        refused("vary: {}\nvariants: {'../a': {}}", "a name must have 1 to 64 letters");
    }

    private static void refused(String campaign, String message) {
        assertThatThrownBy(() -> CampaignSite.plan(directory, "scene: site.yaml\nruns: 2\n" + campaign))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(message);
    }
}
