package org.dronewatch.report;

import java.nio.file.Path;
import java.util.List;
import org.dronewatch.analysis.FieldSummary;

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
    public void write(FieldSummary summary, CoverageInputs inputs) {
        directory.write(() -> {
            JsonFile.write(directory.file("coverage.json"), FieldFile.toJson(summary, inputs));
            directory.publish(List.of());
        });
    }

    /** Removes what was not written completely. */
    @Override
    public void close() {
        directory.close();
    }
}
