package org.dronewatch.report.coverage.table;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.Test;

class SensorCausesTableTest {
    @Test
    void eachSensorHasARowWithItsOwnCauses() {
        Map<String, Map<Cause, Integer>> causes = new LinkedHashMap<>();
        causes.put("guard", Map.of(Cause.OUT_OF_VIEW, 740, Cause.TOO_SLOW, 190, Cause.HIDDEN_BY_BUILDING, 70));
        causes.put("ears", Map.of(Cause.TOO_WEAK, 996, Cause.DETECTED, 4));
        SensorCausesTable table = new SensorCausesTable(causes, 1000);

        assertThat(table.lines().stream().map(line -> line.replaceAll(" {2,}", " | ")))
                .containsExactly(
                        "causes of each sensor's misses, in % of the known cells at all heights:",
                        "sensor | detected | out of view | too slow | hidden by a building | signal too weak",
                        "guard | - | 74.0 | 19.0 | 7.0 | -",
                        "ears | 0.4 | - | - | - | 99.6");
        assertThat(table.html()).contains("out of view [%]", ">guard<", ">74.0<");
    }

    /** The causes of a single sensor are the dominant ones. */
    @Test
    void aSingleSensorNeedsNoTable() {
        SensorCausesTable table = new SensorCausesTable(Map.of("guard", Map.of(Cause.OUT_OF_VIEW, 10)), 10);

        assertThat(table.lines()).isEmpty();
        assertThat(table.html()).isEmpty();
    }

    @Test
    void ofManySensorsTheReportHasTheRest() {
        Map<String, Map<Cause, Integer>> causes = new LinkedHashMap<>();
        for (int i = 1; i <= 15; i++) {
            causes.put("camera-" + i, Map.of(Cause.TOO_WEAK, 10));
        }
        SensorCausesTable table = new SensorCausesTable(causes, 10);
        List<String> lines = table.lines();

        assertThat(lines).hasSize(15).endsWith("and 3 more sensors in report.html");
        assertThat(lines.get(13)).startsWith("camera-12 ");
        assertThat(table.html()).contains(">camera-15<");
    }

    /** The line that says so would be as long as the row that it leaves out. */
    @Test
    void aSingleSensorIsNotLeftOut() {
        Map<String, Map<Cause, Integer>> causes = new LinkedHashMap<>();
        for (int i = 1; i <= 13; i++) {
            causes.put("camera-" + i, Map.of(Cause.TOO_WEAK, 10));
        }
        List<String> lines = new SensorCausesTable(causes, 10).lines();

        assertThat(lines).hasSize(15);
        assertThat(lines.get(14)).startsWith("camera-13 ");
    }
}
