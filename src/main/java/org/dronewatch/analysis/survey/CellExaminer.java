package org.dronewatch.analysis.survey;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.run.Stage;

/**
 * Assesses individual cells of a coverage again, to give the evidence that the field does not keep: the signal of each
 * sensor, its threshold, and what hides the drone. Keeps scratch memory: for use by one thread at a time.
 */
public final class CellExaminer {
    private final FieldCoverage coverage;
    private final BlockerSearch search;

    /**
     * How each sensor detects a drone in a cell, on the course that determines whether the cell is covered.
     *
     * @param sensors the assessment by each sensor, in the order of the field
     * @param deciding index in the list of the sensor whose cause is the dominant one, as
     *     {@link FieldCoverage#deciding} defines it, but judged by exact margins
     */
    public record CellEvidence(List<GapEvidence.Examined> sensors, int deciding) {
        /** Copies the list: later changes by the caller have no effect. */
        public CellEvidence {
            sensors = List.copyOf(sensors);
        }
    }

    /**
     * An examiner of the cells of a coverage.
     *
     * @param stage the site for which the coverage was assessed
     */
    public CellExaminer(FieldCoverage coverage, Stage stage) {
        this.coverage = coverage;
        this.search = new BlockerSearch(stage);
    }

    /** The evidence for a cell; empty where the drone cannot be. Takes a few milliseconds per microphone. */
    public Optional<CellEvidence> examine(int height, int column, int row) {
        DetectionField field = coverage.field();
        if (!field.isOpen(height, column, row) || field.sensors().isEmpty()) {
            return Optional.empty();
        }
        List<GapEvidence.Examined> examined = IntStream.range(0, field.sensors().size())
                .mapToObj(sensor -> GapEvidence.examine(coverage, sensor, height, column, row, search))
                .toList();
        int deciding = coverage.deciding(
                height, column, row, sensor -> examined.get(sensor).assessment().marginDb());
        return Optional.of(new CellEvidence(examined, deciding));
    }
}
