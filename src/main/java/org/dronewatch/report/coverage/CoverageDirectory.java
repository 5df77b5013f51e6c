package org.dronewatch.report.coverage;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.dronewatch.report.JsonFile;
import org.dronewatch.report.OutputDirectory;

/** The directory into which {@code coverage} writes; its files appear together, or none of them. */
public final class CoverageDirectory implements AutoCloseable {
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
     * Writes all files, on the threads of the {@link org.dronewatch.parallel.Workers} that call.
     *
     * @param site the scene that was assessed
     * @param provenance origin of the results, as names and values
     * @throws org.dronewatch.setting.InputException when writing fails
     */
    public void write(
            CoverageFindings findings, CoverageInputs inputs, CoverageSite site, Map<String, String> provenance) {
        directory.write(() -> {
            JsonFile.write(directory.file("coverage.json"), FieldFile.toJson(findings, inputs));
            Map<String, MapSheet> maps =
                    new FieldPictures(site, inputs, findings.visible().grid()).all(findings);
            for (Map.Entry<String, MapSheet> map : maps.entrySet()) {
                write(map.getKey(), map.getValue());
            }
            try (OutputStream page = Files.newOutputStream(directory.file("report.html"))) {
                new CoverageReport(findings, inputs, site).write(page, maps.values(), provenance);
            }
            directory.publish(List.of());
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
