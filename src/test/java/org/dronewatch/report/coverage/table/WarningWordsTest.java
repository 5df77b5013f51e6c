package org.dronewatch.report.coverage.table;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.IntPredicate;
import java.util.function.IntToDoubleFunction;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.Warning;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.coverage.FieldFile;
import org.dronewatch.report.coverage.WarningMap;
import org.dronewatch.report.coverage.WarningWords;
import org.dronewatch.report.sheet.MapSheet;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;

/** Flights at 10 m/s to a zone of 50 m, with times that are given: what is said of them in words, numbers and lines. */
class WarningWordsTest {
    private static final double REACH = 200.0;
    private static final double LONGEST = 15.0;
    private static final Position TARGET = new Position(50, 50, 0);

    @TempDir
    private Path directory;

    /** Time by bearing, s; below 0 for none. */
    private static InboundWarnings flights(double response, IntToDoubleFunction times, IntPredicate fromStart) {
        List<Warning> all = new ArrayList<>();
        for (double height : new double[] {10, 60}) {
            for (int bearing = 0; bearing < 36; bearing++) {
                double time = times.applyAsDouble(bearing);
                all.add(new Warning(
                        Math.toRadians(10.0 * bearing),
                        height,
                        50,
                        time < 0 ? OptionalDouble.empty() : OptionalDouble.of(50 + 10 * time),
                        time < 0 ? OptionalDouble.empty() : OptionalDouble.of(time),
                        fromStart.test(bearing)));
            }
        }
        return new InboundWarnings(TARGET, REACH, LONGEST, response, true, all);
    }

    private static String words(InboundWarnings warnings) {
        return new WarningWords(warnings).html() + new WarningWords(warnings).worstInWords();
    }

    private static List<Warning> at10(InboundWarnings warnings) {
        return warnings.all().stream().filter(one -> one.height() == 10.0).toList();
    }

    private static String table(InboundWarnings warnings) {
        return String.join("\n", WarningTable.lines(warnings, FieldCoverage.DEFAULT_COVERED));
    }

    @Test
    void whatTheDistanceForcesIsNotCalledAFailure() {
        InboundWarnings all = flights(30, bearing -> LONGEST, bearing -> true);
        assertThat(words(all))
                .contains("The flights begin 200 m away, so no warning can exceed 15 s.")
                .contains("That is less than the response takes")
                .contains("at least 15 s from every bearing")
                .contains("shortest warning of a straight inbound flight comes at least 15 s before")
                .contains("In 72 of 72 cases, it is unknown whether the required warning of 30 s is given: the drone")
                .doesNotContain("not met");
        assertThat(table(all))
                .contains(">= 15.0 s from all bearings")
                .contains("unknown whether a warning of 30 s is given: 72 of 72 flights")
                .doesNotContain("36 of 36 bearings");
    }

    @Test
    void whatIsMissedAtFirstIsLate() {
        InboundWarnings some = flights(12, bearing -> bearing < 2 ? 9 : LONGEST, bearing -> bearing >= 2);
        assertThat(words(some))
                .contains("no warning can exceed 15 s.")
                .contains("The shortest warning of a straight inbound flight comes 9 s before")
                .contains("The required warning of 12 s is not given in 4 of 72 cases.")
                .doesNotContain("unknown", "less than the response takes");
        assertThat(table(some))
                .contains("  9.0 s from 0 to 10 deg   >= 15.0 s")
                .contains("2 of 36 bearings")
                .doesNotContain("unknown");
    }

    @Test
    void noBearingIsSingledOutAmongEquals() {
        assertThat(table(flights(0, bearing -> -1, bearing -> false))).contains("none from any bearing");
        assertThat(table(flights(0, bearing -> bearing >= 34 || bearing < 2 ? 3 : 8, bearing -> false)))
                .contains("  3.0 s from 340 to 10 deg  ");
        assertThat(table(flights(0, bearing -> bearing == 16 ? 8 : 3, bearing -> false)))
                .contains("  3.0 s from all bearings but 160 deg  ");
        assertThat(table(flights(0, bearing -> bearing < 35 && bearing > 1 ? -1 : 3, bearing -> false)))
                .contains("  none except from 350 to 10 deg  ");
        assertThat(table(flights(0, bearing -> bearing % 2, bearing -> false)))
                .contains("  0.0 s from 18 of 36 bearings  ");
        assertThat(LeastWarning.ofOthers(
                        flights(0, bearing -> bearing % 2 == 0 ? -1 : bearing, bearing -> false)
                                .all(),
                        WarningTable::seconds))
                .contains("1.0\u00a0s or more");
        assertThat(WarningTable.leastAndOthers(
                        at10(flights(0, bearing -> bearing < 35 && bearing > 1 ? -1 : 3, bearing -> false))))
                .isEqualTo("none except from 350 to 10 deg: 3.0\u00a0s or more");
        assertThat(WarningTable.leastAndOthers(at10(flights(0, bearing -> bearing < 5 ? -1 : 8, bearing -> false))))
                .isEqualTo("none from 0 to 40 deg, 8.0\u00a0s or more from the others");
        assertThat(LeastWarning.ofOthers(
                        flights(0, bearing -> bearing, bearing -> false).all(), WarningTable::seconds))
                .isEmpty();
        assertThat(table(flights(0, bearing -> bearing == 7 ? 3 : 8, bearing -> false)))
                .contains("  3.0 s from 70 deg  ");
        assertThat(words(flights(0, bearing -> bearing == 9 ? 3 : 8, bearing -> false)))
                .contains(
                        "3 s from the east",
                        "comes 3 s before it reaches the protected zone; this happens in 2 of 72 combinations");
        assertThat(words(flights(0, bearing -> bearing < 5 ? -1 : 8, bearing -> false)))
                .contains(
                        "none from 0 to 40 deg, 8\u00a0s or more from the others",
                        "5 of 36",
                        "undetected; this happens in 10 of 72 combinations");
    }

    /** The target is not the middle of the grid, so that its map would end 150 m north of the target. */
    @Test
    void theMapShowsWhereAllFlightsBegin() throws IOException {
        FieldSite site = FieldSite.in(directory, FieldSite.ROUND);
        FieldGrid grid = new FieldGrid(0, 0, 400, 40, List.of(10.0, 60.0));
        CoverageInputs inputs = new CoverageInputs(
                "boxes", FieldSite.DRONE, "best", 0.5, FieldTerms.ONE_LOOK, Optional.empty(), Optional.empty());
        InboundWarnings all = flights(30, bearing -> 10, bearing -> bearing % 2 == 0);
        CoverageSite there = new CoverageSite(site.settings(), site.stage());
        MapSheet sheet = new WarningMap(there, inputs).sheet(grid, new int[1000 * 1000], all);
        int radius = (int) Math.round(1000 * REACH / (2.1 * REACH));
        assertThat(sheet.colour(500, 500 - radius)).isEqualTo(Color.GRAY);
        assertThat(sheet.colour(500 - radius, 500)).isEqualTo(Color.GRAY);

        FieldSummary summary = FieldSummary.of(site.field(grid, 2), FieldCoverage.Choice.BEST, 0.5);
        JsonNode json = FieldFile.toJson(
                new FieldSurvey(grid, summary, Optional.empty(), Optional.empty(), Optional.of(all)), inputs);
        JsonNode open = json.get("warning").get(0);
        assertThat(open.get("in_time").isNull()).isTrue();
        assertThat(open.get("at_least").asBoolean()).isTrue();
        JsonNode late = json.get("warning").get(1);
        assertThat(late.get("in_time").isBoolean()).isTrue();
        assertThat(late.get("in_time").asBoolean()).isFalse();
        assertThat(late.get("at_least").asBoolean()).isFalse();
    }
}
