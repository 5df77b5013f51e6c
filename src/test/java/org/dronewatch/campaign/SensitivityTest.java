package org.dronewatch.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Cases;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The further cases of a campaign, with results computed from their values instead of by runs. */
class SensitivityTest {
    private static final String FACTORS =
            """
            scene: site.yaml
            vary:
              drones.intruder.flight.distance: {uniform: {from: 400 m, to: 600 m}}
              drones.intruder.flight.height: {uniform: {from: 40 m, to: 60 m}}
            runs: 2
            """;

    @TempDir
    private Path directory;

    private CampaignPlan plan(String sensitivity) throws IOException {
        return CampaignSite.plan(directory, FACTORS + "sensitivity: " + sensitivity);
    }

    /** A warning of 3 per metre of distance and 40 per metre of height, plus a uniform number of a width of 800. */
    private static double warning(Cases cases, int number) {
        List<String> values = cases.values(number);
        double chance = (cases.seed(number) >>> 3) % 100_000 / 1e5;
        return 3.0 * metres(values.get(0)) + 40.0 * metres(values.get(1)) + 800.0 * chance;
    }

    private static double metres(String text) {
        return Double.parseDouble(text.replace(" m", ""));
    }

    private static Sensitivity of(SensitivityCases cases) {
        Sensitivity sensitivity = new Sensitivity(cases);
        List<CaseResult> results = new ArrayList<>();
        for (int number = 0; number < cases.size(); number++) {
            results.add(new CaseResult(
                    number,
                    "scene",
                    cases.seed(number),
                    cases.values(number),
                    Optional.empty(),
                    OptionalDouble.empty(),
                    OptionalDouble.empty(),
                    Optional.empty(),
                    OptionalDouble.empty(),
                    OptionalDouble.empty(),
                    OptionalDouble.of(warning(cases, number)),
                    Optional.empty(),
                    OptionalDouble.empty(),
                    false,
                    Map.of()));
        }
        sensitivity.add(results);
        return sensitivity;
    }

    /** Uniform widths of 600, 800 and 800: variances as 9 to 16 to 16. */
    @Test
    void chanceIsSeparatedFromTheSettings() throws IOException {
        SensitivityCases cases =
                plan("{method: sobol, base: 4000}").sensitivity().orElseThrow();
        List<Sensitivity.Influence> influences = of(cases).influences();

        assertThat(cases.size()).isEqualTo(4000 * 5);
        assertThat(influences.stream().map(Sensitivity.Influence::path))
                .containsExactly("drones.intruder.flight.distance", "drones.intruder.flight.height", "run.seed");
        double[] parts = {9.0 / 41.0, 16.0 / 41.0, 16.0 / 41.0};
        for (int i = 0; i < parts.length; i++) {
            assertThat(influences.get(i).index().orElseThrow().first()).isCloseTo(parts[i], within(0.05));
            assertThat(influences.get(i).index().orElseThrow().total()).isCloseTo(parts[i], within(0.05));
        }
    }

    @Test
    void elementaryEffectsAreThoseOfTheWholeRange() throws IOException {
        SensitivityCases cases =
                plan("{method: morris, base: 30}").sensitivity().orElseThrow();
        List<Sensitivity.Influence> influences = of(cases).influences();

        assertThat(cases.size()).isEqualTo(30 * 4);
        assertThat(influences.get(0).effect().orElseThrow().magnitude()).isCloseTo(600.0, within(1e-6));
        assertThat(influences.get(1).effect().orElseThrow().magnitude()).isCloseTo(800.0, within(1e-6));
        assertThat(influences.get(1).effect().orElseThrow().deviation()).isCloseTo(0.0, within(1e-6));
        assertThat(influences.get(2).effect().orElseThrow().deviation()).isGreaterThan(100.0);
    }

    @Test
    void aMissCountsAsNoWarningAndAFailedCaseLeavesItsGroupOut() throws IOException {
        SensitivityCases cases = plan("{method: sobol, base: 2}").sensitivity().orElseThrow();
        Sensitivity sensitivity = new Sensitivity(cases);
        CaseResult failed = CaseResult.failed(0, "scene", 1, cases.values(0), "no");

        sensitivity.add(List.of(failed));

        assertThat(sensitivity.failed()).isEqualTo(1);
        assertThat(sensitivity.isComplete()).isFalse();
        assertThat(sensitivity.influences()).isEmpty();
    }

    /** No factor has an effect on what never changes, by either method. */
    @Test
    void whatIsTheSameInAllCasesHasNoInfluences() throws IOException {
        for (String method : List.of("sobol", "morris")) {
            SensitivityCases cases = plan("{method: " + method + ", base: 3, output: range_m}")
                    .sensitivity()
                    .orElseThrow();
            Sensitivity sensitivity = of(cases);

            assertThat(sensitivity.isComplete()).isTrue();
            assertThat(sensitivity.isEstimable()).isTrue();
            assertThat(sensitivity.influences()).as(method).isEmpty();
        }
    }

    /** Nothing is protected without a zone, and no time is required without a response. */
    @Test
    void whatIsNotKnownInAnyCaseIsRefused() throws IOException {
        Path site = directory.resolve("site.yaml");
        CampaignSite.in(directory, FACTORS);
        String text = Files.readString(site);
        String sobol = FACTORS + "sensitivity: {method: sobol, output: %s}\n";
        String until = FACTORS.replace("runs: 2", "until: {of: in_time, halfWidth: 0.2}");

        Files.writeString(site, text.replaceFirst("(?s)alert:.*run:", "run:"));
        for (String output : List.of("warning_s", "in_time")) {
            refused(
                    String.format(sobol, output),
                    "sensitivity.output: " + output
                            + " is not known in any of the cases, because the scene site protects"
                            + " nothing (alert.protect)");
        }
        refused(until, "until.of: in_time is not known in any of the cases, because the scene site protects nothing");
        assertThat(read(String.format(sobol, "range_m")).sensitivity()).isPresent();

        Files.writeString(site, text.replace("response: 12 s", "response: 0 s"));
        refused(until, "because the scene site states no response time (alert.response)");
        assertThat(read(String.format(sobol, "warning_s")).sensitivity()).isPresent();
        assertThat(read(until.replace("vary:", "vary:\n  alert.response: {values: [0 s, 9 s]}"))
                        .size())
                .isPositive();
    }

    private CampaignPlan read(String campaign) throws IOException {
        Path file = Files.writeString(directory.resolve("asked.campaign.yaml"), campaign);
        return new CampaignPlan(CampaignReader.read(file), directory, note -> {});
    }

    private void refused(String campaign, String message) {
        assertThatThrownBy(() -> read(campaign))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(message);
    }

    @Test
    void whatCannotBeEstimatedIsRefused() throws IOException {
        assertThat(plan("{method: none}").sensitivity()).isEmpty();
        assertThatThrownBy(() -> plan("{method: sobol, base: 1}")).hasMessageContaining("base");
        assertThatThrownBy(() -> plan("{method: sobol, variant: other}"))
                .hasMessageContaining("the campaign has scene");
        Files.writeString(directory.resolve("speeds.csv"), "drones.intruder.speed\n12 m/s\n");
        assertThatThrownBy(() -> plan("{method: sobol}\ntable: speeds.csv"))
                .hasMessage("sensitivity: needs settings whose values are drawn, not those of the table speeds.csv");
    }
}
