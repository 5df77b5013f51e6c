package org.dronewatch.report.coverage;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.dronewatch.analysis.field.FieldSummary;
import org.dronewatch.report.JsonFile;
import org.dronewatch.report.Numbers;
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
     * Writes all files.
     *
     * @throws org.dronewatch.setting.InputException when writing fails
     */
    public void write(CoverageFindings findings, CoverageInputs inputs, FieldPictures pictures) {
        FieldSummary summary = findings.summary();
        directory.write(() -> {
            JsonFile.write(directory.file("coverage.json"), FieldFile.toJson(findings, inputs));
            for (int height = 0; height < summary.heights().size(); height++) {
                String metres = Numbers.text(summary.heights().get(height).height());
                write("cause-" + metres + ".png", pictures.causes(summary, height));
            }
            write("visible-height.png", pictures.visibleHeights(findings.visible()));
            write("min-height.png", pictures.detectableHeights(findings.detectable()));
            write("warning.png", pictures.warnings(findings.visible().grid(), findings.warnings()));
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
