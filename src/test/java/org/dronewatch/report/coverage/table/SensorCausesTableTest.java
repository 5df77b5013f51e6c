package org.dronewatch.report.coverage.table;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class SensorCausesTableTest {
    private static final FieldTerms ONE_LOOK = FieldTerms.ONE_LOOK;
    private static final String REPORT = "see field/report.html";

    private static CoverageInputs inputs(FieldTerms terms, double covered, Optional<String> area) {
        return new CoverageInputs("site", "one", "worst", covered, terms, area, Optional.empty());
    }

    /** The fractions are of the zone, and detected is not the same as covered. */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '"',
            value = {
                "0.5 |   | at all heights",
                "0.5 | z | in 'z' at all heights",
                "0.9 | z | in 'z' at all heights",
            })
    void theTitleStatesOfWhatTheFractionsAre(double covered, String area, String end) {
        Map<String, Map<Cause, Integer>> causes = new LinkedHashMap<>();
        causes.put("guard", Map.of(Cause.OUT_OF_VIEW, 10));
        causes.put("ears", Map.of(Cause.DETECTED, 10));
        CoverageInputs inputs = inputs(ONE_LOOK, covered, Optional.ofNullable(area));
        SensorCausesTable table = new SensorCausesTable(causes, 10);

        String detected = "Here, \"detected\" means a probability of 0.5 or more in a single look.";
        List<String> lines = table.lines(inputs, REPORT);
        assertThat(lines.get(0))
                .isEqualTo("what each sensor detects by itself, and why it misses the rest, in % of the known cells "
                        + end + ":");
        assertThat(lines.contains(detected)).isEqualTo(covered != 0.5);
        assertThat(table.html(inputs)).contains("in % of the known area " + end + ".");
        assertThat(table.html(inputs).contains("means a probability of 0.5 or more in a single look."))
                .isEqualTo(covered != 0.5);
    }

    @Test
    void eachSensorHasARowWithItsOwnCauses() {
        Map<String, Map<Cause, Integer>> causes = new LinkedHashMap<>();
        causes.put("guard", Map.of(Cause.OUT_OF_VIEW, 740, Cause.TOO_SLOW, 190, Cause.HIDDEN_BY_BUILDING, 70));
        causes.put("ears", Map.of(Cause.TOO_WEAK, 996, Cause.DETECTED, 4));
        SensorCausesTable table = new SensorCausesTable(causes, 1000);

        assertThat(table.lines(inputs(ONE_LOOK, 0.5, Optional.empty()), REPORT).stream()
                        .map(line -> line.replaceAll(" {2,}", " | ")))
                .containsExactly(
                        "what each sensor detects by itself, and why it misses the rest, in % of the known cells at"
                                + " all heights:",
                        "sensor | detected | out of view | too slow | hidden by a building | signal too weak",
                        "guard | - | 74.0 | 19.0 | 7.0 | -",
                        "ears | 0.4 | - | - | - | 99.6");
        assertThat(table.html(inputs(ONE_LOOK, 0.5, Optional.empty())))
                .contains("out of view [%]", ">guard<", ">74.0<");
    }

    /** The causes of a single sensor are the dominant ones. */
    @Test
    void aSingleSensorNeedsNoTable() {
        SensorCausesTable table = new SensorCausesTable(Map.of("guard", Map.of(Cause.OUT_OF_VIEW, 10)), 10);

        assertThat(table.lines(inputs(ONE_LOOK, 0.5, Optional.empty()), REPORT)).isEmpty();
        assertThat(table.html(inputs(ONE_LOOK, 0.5, Optional.empty()))).isEmpty();
    }

    @Test
    void ofManySensorsTheReportHasTheRest() {
        Map<String, Map<Cause, Integer>> causes = new LinkedHashMap<>();
        for (int i = 1; i <= 15; i++) {
            causes.put("camera-" + i, Map.of(Cause.TOO_WEAK, 10));
        }
        SensorCausesTable table = new SensorCausesTable(causes, 10);
        List<String> lines = table.lines(inputs(ONE_LOOK, 0.5, Optional.empty()), REPORT);

        assertThat(lines).hasSize(15).endsWith("and 3 more sensors (see field/report.html)");
        assertThat(lines.get(13)).startsWith("camera-12 ");
        assertThat(table.html(inputs(ONE_LOOK, 0.5, Optional.empty()))).contains(">camera-15<");
    }

    /** The line that says so would be as long as the row that it leaves out. */
    @Test
    void aSingleSensorIsNotLeftOut() {
        Map<String, Map<Cause, Integer>> causes = new LinkedHashMap<>();
        for (int i = 1; i <= 13; i++) {
            causes.put("camera-" + i, Map.of(Cause.TOO_WEAK, 10));
        }
        List<String> lines = new SensorCausesTable(causes, 10).lines(inputs(ONE_LOOK, 0.5, Optional.empty()), REPORT);

        assertThat(lines).hasSize(15);
        assertThat(lines.get(14)).startsWith("camera-13 ");
    }
}
