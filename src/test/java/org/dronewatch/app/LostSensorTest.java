package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.app.Program.Outcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What is lost without a sensor, against the coverage of a scene without it, for which nothing is kept. */
class LostSensorTest {
    /** Two radars one above the other, so that the middle of the area stays where it is. */
    private static final String SENSORS = FieldSite.ROUND
            + FieldSite.ROUND
                    .replace("round", "chance")
                    .replace("0, 4]", "0, 30]")
                    .replace("maxRange: 150", "maxRange: 90")
                    .replace("0.01}}", "0.01}, detection: {kind: chance, pulses: 8}}");

    @TempDir
    private Path directory;

    @Thorough
    @Test
    void whatIsLostIsTheDifferenceToASceneWithoutTheSensor() throws IOException {
        FieldSite.in(directory, SENSORS);
        JsonNode all = coverage("all");
        JsonNode rest = coverage("rest", "--set", "sensors.round.enabled=false");
        for (int height = 0; height < 2; height++) {
            JsonNode with = all.get("heights").get(height);
            JsonNode without = rest.get("heights").get(height);
            assertThat(without.get("known")).isEqualTo(with.get("known"));
            double lost = with.get("covered_share").asDouble()
                    - without.get("covered_share").asDouble();
            assertThat(with.get("n_minus_1").get("round").asDouble()).isCloseTo(lost, within(2e-6));
            assertThat(with.get("covered_share").asDouble()).isPositive();
        }
        assertThat(rest.get("west_m")).isEqualTo(all.get("west_m"));
        assertThat(all.get("heights").get(1).get("n_minus_1").get("round").asDouble())
                .isNotZero();
    }

    private JsonNode coverage(String out, String... more) throws IOException {
        Path results = directory.resolve(out);
        List<String> command = new ArrayList<>(
                List.of("coverage", directory.resolve("site.yaml").toString()));
        Collections.addAll(command, "--heights=12,60", "--side=400", "--cell=20", "--heading=best", "--no-cache");
        Collections.addAll(command, "--out", results.toString());
        Collections.addAll(command, more);
        Outcome outcome = Program.run(command.toArray(String[]::new));
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return JsonMapper.builder()
                .build()
                .readTree(results.resolve("coverage.json").toFile());
    }
}
