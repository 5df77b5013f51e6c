package org.dronewatch.fusion;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronewatch.tracking.AssessedLook;
import org.junit.jupiter.api.Test;

class ForecastLogTest {
    private static final int CONTACT = 7;

    private static ForecastLog log(double probability) {
        return ForecastLog.of(AlertSettings.DEFAULT.withRule(AlertRule.UnionOfProbabilities.of(probability)))
                .orElseThrow();
    }

    private static AssessedLook likely(String sensor, double time, double probability) {
        return new AssessedLook(CONTACT, sensor, time, probability);
    }

    /** 1 - 0.4 * 0.5 * 0.7 = 0.86. */
    @Test
    void probabilitiesOfIndependentSensorsJoin() {
        List<AssessedLook> looks = List.of(likely("a", 0, 0.6), likely("b", 0, 0.5), likely("c", 0, 0.3));
        for (double probability : new double[] {0.8599, 0.86}) {
            ForecastLog log = log(probability);
            assertThat(log.add(looks)).containsExactly(new Alert(CONTACT, 0.0, List.of("a", "b", "c")));
            assertThat(log.alert(CONTACT).orElseThrow().sensors()).containsExactly("a", "b", "c");
            assertThat(log.add(looks)).as("only the first").isEmpty();
        }
        ForecastLog log = log(0.8601);
        log.add(looks);
        assertThat(log.alert(CONTACT)).isEmpty();
        // A look of long ago does not count.
        log.add(List.of(likely("c", 3, 0.8)));
        assertThat(log.alert(CONTACT)).isEmpty();
    }

    @Test
    void anAlertRestsOnTheLikeliestAlone() {
        ForecastLog log = log(0.9);
        log.add(List.of(likely("faint", 0, 0.01), likely("sure", 0, 0.95), likely("fair", 0, 0.5)));

        assertThat(log.alert(CONTACT).orElseThrow().sensors()).containsExactly("sure");
    }

    @Test
    void whatHasEndedIsForgotten() {
        ForecastLog log = log(0.9);
        log.add(List.of(likely("a", 0, 0.95)));
        log.forget(List.of(CONTACT));
        assertThat(log.alert(CONTACT)).isEmpty();
    }

    @Test
    void rulesThatDecideForecastNothing() {
        assertThat(ForecastLog.of(AlertSettings.DEFAULT)).isEmpty();
        assertThat(ForecastLog.of(AlertSettings.DEFAULT.withRule(AlertRule.SeveralSensors.of(2))))
                .isEmpty();
    }
}
