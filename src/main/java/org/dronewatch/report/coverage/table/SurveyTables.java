package org.dronewatch.report.coverage.table;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.analysis.survey.FieldSurvey;

/** All tables of a survey of the coverage. */
public final class SurveyTables {
    private SurveyTables() {}

    /** What is missing because of an interruption: {@code complete for 3 of 5 heights; missing: warnings}. */
    public static String missing(FieldSurvey survey) {
        List<String> missing = new ArrayList<>();
        if (survey.visible().isEmpty()) {
            missing.add("lowest visible heights");
        }
        if (survey.detectable().isEmpty()) {
            missing.add("lowest detection heights");
        }
        if (survey.warnings().isEmpty()) {
            missing.add("warnings");
        }
        int conditions = survey.asked() - Math.max(0, survey.conditions().size() - 1);
        if (conditions > 0) {
            missing.add(conditions + " of " + survey.asked() + " conditions");
        }
        return "complete for " + survey.summary().heights().size() + " of "
                + survey.grid().heights().size() + " heights"
                + (missing.isEmpty() ? "" : "; missing: " + String.join(", ", missing));
    }

    /**
     * The tables of what was completed, separated by empty lines.
     *
     * @param report where the rows that are not printed can be found, such as {@code in field/report.html}
     */
    public static List<String> lines(FieldSurvey survey, CoverageInputs inputs, String report) {
        List<List<String>> tables = new ArrayList<>(causes(survey.summary(), inputs, report));
        survey.visible().map(FieldTable::visible).ifPresent(tables::add);
        survey.detectable()
                .map(heights -> FieldTable.detectable(heights, inputs))
                .ifPresent(tables::add);
        tables.add(FieldTable.gaps(survey.summary()));
        tables.add(FieldTable.losses(survey.summary(), inputs));
        survey.warnings()
                .map(warnings -> WarningTable.lines(warnings, inputs.covered()))
                .ifPresent(tables::add);
        if (!survey.conditions().isEmpty()) {
            tables.add(ConditionTable.lines(survey.conditions(), inputs.covered()));
        }
        tables.add(FieldTable.interpolated(survey.summary()));
        tables.removeIf(List::isEmpty);
        List<String> lines = new ArrayList<>();
        for (List<String> table : tables) {
            if (!lines.isEmpty()) {
                lines.add("");
            }
            lines.addAll(table);
        }
        return lines;
    }

    /** The dominant causes and those of each sensor; below the last of them, why a radar may be blind. */
    private static List<List<String>> causes(FieldSummary summary, CoverageInputs inputs, String report) {
        List<List<String>> tables = new ArrayList<>();
        tables.add(new ArrayList<>(FieldTable.causes(summary, inputs)));
        List<String> bySensor = new SensorCausesTable(summary).lines(inputs, report);
        if (!bySensor.isEmpty()) {
            tables.add(bySensor);
        }
        FieldTable.slownessInWords(summary, inputs)
                .map("too slow: "::concat)
                .ifPresent(tables.get(tables.size() - 1)::add);
        FieldTable.unknownInWords(summary).map("unknown: "::concat).ifPresent(tables.get(0)::add);
        return tables;
    }
}
