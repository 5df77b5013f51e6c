package org.dronewatch.report.coverage.table;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.survey.GapEvidence;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.Signal;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Why a sensor misses the drone in a gap, from assessments that are made up. */
class MissWordsTest {
    @TempDir
    private static Path directory;

    private static SensorSettings<?> radar;

    @BeforeAll
    static void site() throws IOException {
        radar = FieldSite.in(directory, FieldSite.ROUND)
                .settings()
                .enabledSensors()
                .get("round");
    }

    private static GapEvidence.Examined examined(Signal signal, Explanation explanation) {
        return new GapEvidence.Examined(new Assessment(signal, explanation), Optional.empty());
    }

    private static GapEvidence.Examined weak(double decibels) {
        return examined(Signal.certain(13.0 + decibels, "dB", 13.0), Explanation.of(Cause.TOO_WEAK));
    }

    private static MissWords words(Map<Cause, Integer> causes, GapEvidence.Examined... examined) {
        return new MissWords(new GapEvidence("round", new EnumMap<>(causes), List.of(examined)), radar);
    }

    /** Less than all is never 100 %, and more than nothing never 0 %. */
    @ParameterizedTest
    @CsvSource({
        "1, 1000, less than 1 %",
        "9, 1000, less than 1 %",
        "10, 1000, 1 %",
        "994, 1000, 99 %",
        "995, 1000, more than 99 %",
        "999, 1000, more than 99 %",
        "1000, 1000, 100 %",
        "1, 2, 50 %"
    })
    void percentagesOfPartsAreThoseOfParts(int cells, int of, String words) {
        assertThat(MissWords.percent(cells, of)).isEqualTo(words);
    }

    @ParameterizedTest
    @CsvSource({
        "0, 4000, -",
        "1, 4000, <0.1",
        "2, 4000, 0.1",
        "3997, 4000, 99.9",
        "3999, 4000, >99.9",
        "4000, 4000, 100.0"
    })
    void soAreThoseOfTables(int cells, int of, String words) {
        assertThat(CoverageTable.percent(cells, of)).isEqualTo(words);
    }

    @Test
    void theMostFrequentCauseComesFirstWithItsFraction() {
        MissWords words = words(
                Map.of(Cause.OUT_OF_RANGE, 996, Cause.TOO_WEAK, 4),
                examined(Signal.certain(1.0, "dB", 13.0), Explanation.beyond(Cause.OUT_OF_RANGE, 150.0)),
                weak(-2.04),
                weak(-9.0));
        assertThat(words.inWords())
                .isEqualTo("more than 99 %: out of range (beyond 150 m); less than 1 %: "
                        + radar.description().weakness()
                        + " by 2.0 to 9.0 dB (at best 11.0 dB, threshold 13 dB)");
        assertThat(words.bestMargin()).isCloseTo(-2.04, within(1e-9));
    }

    /** A single cause has no fraction; a margin that rounds to nothing is less than what is shown. */
    @Test
    void missingMarginsAreNeverNothing() {
        assertThat(words(Map.of(Cause.TOO_WEAK, 8), weak(-0.01)).inWords())
                .startsWith(radar.description().weakness() + " by less than 0.1 dB (at best ");
        MissWords silent = words(
                Map.of(Cause.TOO_WEAK, 8),
                examined(Signal.certain(Double.NEGATIVE_INFINITY, "dB", 13.0), Explanation.of(Cause.TOO_WEAK)));
        assertThat(silent.inWords())
                .isEqualTo(radar.description().weakness() + ": nothing measurable reaches the sensor");
        assertThat(silent.bestMargin()).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    @Test
    void otherCausesStateWhatLimitsThem() {
        assertThat(words(
                                Map.of(Cause.TOO_SLOW, 3),
                                examined(Signal.certain(1, "dB", 13), Explanation.beyond(Cause.TOO_SLOW, 3.0)))
                        .inWords())
                .isEqualTo("too slow (limit: 3 m/s)");
        assertThat(words(
                                Map.of(Cause.DETECTED, 3),
                                examined(Signal.of(0.61, 14, "dB", 13), Explanation.DETECTED),
                                examined(Signal.of(0.87, 15, "dB", 13), Explanation.DETECTED))
                        .inWords())
                .isEqualTo("detected, but with too low a probability (at most 0.87 in one look)");
        assertThat(words(Map.of(Cause.UNKNOWN, 3)).inWords())
                .isEqualTo("unknown: the line of sight leaves the known ground");
        List<String> plain = new ArrayList<>();
        for (Cause cause : List.of(Cause.OUT_OF_VIEW, Cause.SILENT, Cause.HIDDEN_BY_TERRAIN)) {
            plain.add(words(Map.of(cause, 1)).inWords());
        }
        assertThat(plain).containsExactly("out of view", "no recognised emission", "hidden by terrain");
    }

    @Test
    void aDroneMayBeTooNearOrTooFar() {
        Signal none = Signal.certain(Double.NEGATIVE_INFINITY, "dB", 13.0);
        assertThat(words(
                                Map.of(Cause.OUT_OF_RANGE, 3),
                                examined(none, Explanation.beyond(Cause.OUT_OF_RANGE, 150.0)),
                                examined(none, Explanation.beyond(Cause.OUT_OF_RANGE, 1.0)),
                                examined(none, Explanation.beyond(Cause.OUT_OF_RANGE, 150.0)))
                        .inWords())
                .isEqualTo("out of range (nearer than 1 m, or beyond 150 m)");
    }
}
