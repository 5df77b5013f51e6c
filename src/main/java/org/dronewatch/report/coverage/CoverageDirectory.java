package org.dronewatch.report.coverage;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronewatch.analysis.field.FieldSurvey;
import org.dronewatch.report.JsonFile;
import org.dronewatch.report.OutputDirectory;

/** The directory into which {@code coverage} writes; its files appear together, or none of them. */
public final class CoverageDirectory implements AutoCloseable {
    private static final String REPORT = "report.html";

    private final OutputDirectory directory;

    /**
     * Makes sure that the directory can be written, before the work begins.
     *
     * @throws org.dronewatch.setting.InputException when it cannot
     */
    public CoverageDirectory(Path target) {
        this.directory = new OutputDirectory(target);
    }

    /**
     * Writes all files, on the threads of the {@link org.dronewatch.parallel.Workers} that call. Of a survey that was
     * interrupted, those that are whole, without the report; the others of an earlier one are removed.
     *
     * @param site the scene that was assessed
     * @param provenance origin of the results, as names and values
     * @throws org.dronewatch.setting.InputException when writing fails
     */
    public void write(FieldSurvey survey, CoverageInputs inputs, CoverageSite site, Map<String, String> provenance) {
        directory.write(() -> {
            JsonFile.write(directory.file("coverage.json"), FieldFile.toJson(survey, inputs));
            Map<String, MapSheet> maps = new FieldPictures(site, inputs, survey.grid()).all(survey);
            for (Map.Entry<String, MapSheet> map : maps.entrySet()) {
                write(map.getKey(), map.getValue());
            }
            if (survey.isComplete()) {
                try (OutputStream page = Files.newOutputStream(directory.file(REPORT))) {
                    new CoverageReport(survey, inputs, site).write(page, maps.values(), provenance);
                }
            }
            List<String> obsolete = new ArrayList<>(FieldPictures.names(survey.grid()));
            obsolete.add(REPORT);
            obsolete.removeAll(maps.keySet());
            directory.publish(survey.isComplete() ? List.of() : obsolete);
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
