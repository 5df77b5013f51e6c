package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.run.ConfirmationTrial;
import org.dronewatch.run.RunResult;
import org.junit.jupiter.api.Test;

/** Sixty runs of the scene in the docs: its table of what each confirmation gains and costs. */
class FalseAlarmsSceneTest {
    private static final int RUNS = 60;
    private static final long FIRST_SEED = 1;

    /** Confirmation to median alert time of the page, s. */
    private static final Map<String, Double> TIMES =
            Map.of("1 of 1", 2.0, "2 of 3", 6.0, "3 of 5", 10.0, "5 of 8", 15.0);

    @Test
    void theTableOfTheAlertPage() {
        System.out.println("seeds " + FIRST_SEED + " to " + (FIRST_SEED + RUNS - 1));
        SceneRunner runner = new SceneRunner(new SceneFile(Path.of("scenes", "false-alarms.yaml"))).threads(1);
        Map<String, List<Double>> times = new TreeMap<>();
        Map<String, String> prices = new TreeMap<>();
        int alarms = 0;
        for (int i = 0; i < RUNS; i++) {
            RunResult run = runner.seed(FIRST_SEED + i).run().runs().get(0);
            alarms += run.falseAlarms().counted().getOrDefault("radar", 0L);
            for (ConfirmationTrial trial : run.falseAlarms().trials()) {
                String name = trial.confirm().hits() + " of " + trial.confirm().looks();
                times.computeIfAbsent(name, unseen -> new ArrayList<>())
                        .add(trial.alerts().get("intruder").orElse(Double.POSITIVE_INFINITY));
                FalseAlertRate rate = run.falseAlertRate(trial.confirm());
                prices.put(name, rate.inWords());
            }
            // The trial of the scene's own confirmation is what the run itself did.
            assertThat(run.falseAlarms().trials().stream()
                            .filter(trial -> trial.confirm()
                                    .equals(run.settings().alert().confirm()))
                            .findFirst()
                            .orElseThrow()
                            .alerts()
                            .get("intruder"))
                    .isEqualTo(run.alerts().get(0).time());
        }
        times.forEach((name, all) -> {
            Collections.sort(all);
            double median = 0.5 * (all.get(RUNS / 2 - 1) + all.get(RUNS / 2));
            System.out.printf(
                    "%s: %.1f s (%.0f to %.0f), %s%n",
                    name, median, all.get(RUNS / 10), all.get(RUNS - 1 - RUNS / 10), prices.get(name));
            assertThat(median).isCloseTo(TIMES.get(name), within(0.26));
        });
        double expected = 25_938e-6 * 56 * RUNS;
        System.out.printf("%d false alarms of the radar, expected %.1f%n", alarms, expected);
        assertThat((double) alarms).isCloseTo(expected, within(4.0 * Math.sqrt(expected)));
    }
}
