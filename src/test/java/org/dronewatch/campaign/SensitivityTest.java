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
