package org.dronewatch.campaign;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.campaign.outcome.CampaignSummary;
import org.dronewatch.campaign.outcome.CaseResult;
import org.dronewatch.campaign.outcome.Outcome;
import org.dronewatch.statistics.Proportion;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ExpectationTest {
    @TempDir
    private Path directory;

    private static CampaignSummary summary(int detected, int cases) {
        CampaignSummary summary = new CampaignSummary(List.of("scene"));
        for (int number = 0; number < cases; number++) {
            OptionalDouble time = number < detected ? OptionalDouble.of(1.0) : OptionalDouble.empty();
            summary.add(List.of(new CaseResult(
                    number,
                    "scene",
                    1L,
                    List.of(),
                    Optional.empty(),
                    OptionalDouble.empty(),
                    time,
                    Optional.empty(),
                    time,
                    time,
                    OptionalDouble.empty(),
                    Optional.empty(),
                    OptionalDouble.empty(),
                    false,
                    Map.of())));
        }
        return summary;
    }

    /** 31 of 47 detected: Wilson's interval begins at 0.5167, and the one guaranteed by the rule at 31/47 - 0.2. */
    @Test
    void theOutcomeThatDecidesHowManyCasesThereAreIsJudgedByTheGuaranteedInterval() throws IOException {
        CampaignPlan fixed = CampaignSite.plan(directory, "scene: site.yaml\nruns: 47\n");
        CampaignPlan until = CampaignSite.plan(directory, "scene: site.yaml\nuntil: {of: detected, halfWidth: 0.2}\n");
        CampaignSummary summary = summary(31, 47);
        Expectation detected = Expectation.of(Outcome.DETECTED, 0.5);

        assertThat(low(detected, fixed, summary)).isCloseTo(0.5167, within(5e-4));
        assertThat(detected.isMet(fixed, summary)).isTrue();
        assertThat(low(detected, until, summary)).isCloseTo(31.0 / 47.0 - 0.2, within(1e-12));
        assertThat(detected.isMet(until, summary)).isFalse();
        assertThat(Expectation.of(Outcome.ALERTED, 0.5).isMet(until, summary)).isTrue();
        assertThat(detected.isMet(until, summary(6, 7)))
                .as("the rule has not stopped yet")
                .isEqualTo(detected.isMet(fixed, summary(6, 7)));
    }

    private static double low(Expectation one, CampaignPlan plan, CampaignSummary summary) {
        return one.interval(plan, summary).map(Proportion.Interval::low).orElseThrow();
    }
}
