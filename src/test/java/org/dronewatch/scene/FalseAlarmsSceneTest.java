package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.run.ConfirmationTrial;
import org.dronewatch.run.RunResult;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.Test;

/** Sixty runs of the scene in the docs: its table of what each confirmation gains and costs. */
class FalseAlarmsSceneTest {
    private static final int RUNS = 60;
    private static final long FIRST_SEED = 1;

    /** The cells of the page's table by confirmation: alert, false alerts per day of all sensors and of the radar. */
    private static Map<String, List<String>> table() throws IOException {
        Map<String, List<String>> rows = new TreeMap<>();
        for (String line : Files.readAllLines(Path.of("src/site/markdown/alert.md"))) {
            if (line.matches("\\| \\d of \\d \\| \\d+ s \\|.*")) {
                List<String> cells =
                        Arrays.stream(line.split("\\|")).map(String::strip).toList();
                rows.put(cells.get(1), cells.subList(2, 5));
            }
        }
        return rows;
    }

    /** The price by closed form in the table's words, and of the radar alone, of one run's settings. */
    private static List<String> prices(RunResult run, ConfirmationTrial trial) {
        Map<String, SensorSettings<?>> radar =
                Map.of("radar", run.settings().enabledSensors().get("radar"));
        FalseAlertRate alone = FalseAlertRate.of(
                run.settings()
                        .alert()
                        .withConfirmation(
                                trial.confirm().hits(), trial.confirm().looks()),
                radar,
                run.settings().world().weather());
        return List.of(
                FalseAlertRate.brief(run.falseAlertRate(trial.confirm()).perDay()),
                FalseAlertRate.brief(alone.perDay()));
    }

    @Test
    void theTableOfTheAlertPage() throws IOException {
        System.out.println("seeds " + FIRST_SEED + " to " + (FIRST_SEED + RUNS - 1));
        SceneRunner runner = new SceneRunner(new SceneFile(Path.of("scenes", "false-alarms.yaml"))).threads(1);
        Map<String, List<Double>> times = new TreeMap<>();
        Map<String, List<String>> prices = new TreeMap<>();
        int alarms = 0;
        for (int i = 0; i < RUNS; i++) {
            RunResult run = runner.seed(FIRST_SEED + i).run().runs().get(0);
            alarms += run.falseAlarms().counted().getOrDefault("radar", 0L);
            for (ConfirmationTrial trial : run.falseAlarms().trials()) {
                String name = trial.confirm().hits() + " of " + trial.confirm().looks();
                times.computeIfAbsent(name, unseen -> new ArrayList<>())
                        .add(trial.alerts().get("intruder").orElse(Double.POSITIVE_INFINITY));
                prices.put(name, prices(run, trial));
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
        Map<String, List<String>> table = table();
        assertThat(times.keySet()).isEqualTo(table.keySet());
        times.forEach((name, all) -> {
            Collections.sort(all);
            double median = 0.5 * (all.get(RUNS / 2 - 1) + all.get(RUNS / 2));
            System.out.printf(
                    "%s: %.1f s (%.0f to %.0f), %s%n",
                    name, median, all.get(RUNS / 10), all.get(RUNS - 1 - RUNS / 10), prices.get(name));
            List<String> row = table.get(name);
            assertThat(median).isCloseTo(Double.parseDouble(row.get(0).replace(" s", "")), within(0.26));
            // The page writes exponents without leading zeros.
            assertThat(prices.get(name).stream()
                            .map(price -> price.replace("e-0", "e-"))
                            .toList())
                    .as(name)
                    .isEqualTo(row.subList(1, 3));
        });
        double expected = 25_938e-6 * 56 * RUNS;
        System.out.printf("%d false alarms of the radar, expected %.1f%n", alarms, expected);
        assertThat((double) alarms).isCloseTo(expected, within(4.0 * Math.sqrt(expected)));
    }
}
