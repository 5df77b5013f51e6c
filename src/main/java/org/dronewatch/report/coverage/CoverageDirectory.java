package org.dronewatch.report.coverage;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.regex.Pattern;
import org.dronewatch.analysis.survey.FieldSurvey;
import org.dronewatch.report.coverage.table.CoverageInputs;
import org.dronewatch.report.coverage.table.CoverageSite;
import org.dronewatch.report.file.JsonFile;
import org.dronewatch.report.file.OutputDirectory;
import org.dronewatch.report.provenance.ResultKind;
import org.dronewatch.report.sheet.MapSheet;

/** The directory into which {@code coverage} writes; its files appear together or not at all. */
public final class CoverageDirectory implements AutoCloseable {
    private static final String CONDITIONS = "conditions.png";
    private static final String NUMBERS = ResultKind.COVERAGE.sign();

    /**
     * All other files that a coverage may write, at any heights: those of an earlier coverage are removed unless they
     * are replaced.
     */
    private static final Pattern FILES = Pattern.compile("cause-[0-9.]+\\.(png|tif|tif\\.aux\\.xml)|count-[0-9.]+\\.tif"
            + "|(min|visible)-height\\.(png|tif)|(warning|conditions)\\.png|coverage\\.(geojson|kml)|report\\.html");

    private final OutputDirectory directory;

    /**
     * Makes sure that the directory can be written, before the work begins.
     *
     * @throws org.dronewatch.setting.InputException when it cannot be written, or holds the results of another command
     */
    public CoverageDirectory(Path target) {
        ResultKind.COVERAGE.checkAlone(target);
        this.directory = new OutputDirectory(target);
    }

    /**
     * Writes all files, on the {@link org.dronewatch.parallel.Workers} of the calling thread. If the survey was
     * interrupted, writes only the files that are complete, without the report, and removes the other files of an
     * earlier survey.
     *
     * @param site the scene that was assessed
     * @param provenance origin of the results, as names and values
     * @throws org.dronewatch.setting.InputException when writing fails
     */
    public void write(FieldSurvey survey, CoverageInputs inputs, CoverageSite site, Map<String, String> provenance) {
        directory.write(() -> {
            JsonFile.write(directory.file(NUMBERS), FieldFile.toJson(survey, inputs));
            Map<String, MapSheet> maps = new FieldPictures(site, inputs, survey.grid()).all(survey);
            for (Map.Entry<String, MapSheet> map : maps.entrySet()) {
                write(map.getKey(), map.getValue());
            }
            if (!survey.conditions().isEmpty()) {
                try (OutputStream matrix = Files.newOutputStream(directory.file(CONDITIONS))) {
                    new ConditionMatrix(survey.conditions(), inputs).writePng(matrix);
                }
            }
            if (survey.isComplete()) {
                try (OutputStream page = Files.newOutputStream(directory.file("report.html"))) {
                    new CoverageReport(survey, inputs, site).write(page, maps.values(), provenance);
                }
            }
            if (inputs.origin().isPresent()) {
                new GridFiles(survey, inputs, inputs.origin().get()).write(directory);
            }
            directory.publish(directory.former(NUMBERS, FILES));
        });
    }

    private void write(String name, MapSheet sheet) throws IOException {
        try (OutputStream target = Files.newOutputStream(directory.file(name))) {
            sheet.writePng(target);
        }
    }

    /** Removes what was not written completely. */
    @Override
    public void close() {
        directory.close();
    }
}
