package org.dronewatch.viewer.coverage;

import java.util.Optional;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.survey.CellExaminer;
import org.dronewatch.analysis.survey.CellExaminer.CellEvidence;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.coverage.CoverageSkin.SkinCell;
import org.dronewatch.report.coverage.table.CellWords;
import org.dronewatch.viewer.part.Latest;

/**
 * The cell of a coverage under the pointer: what the field holds about it at once, then its evidence, which is assessed
 * on a separate thread.
 */
final class PointedCell implements AutoCloseable {
    private final Latest thread;
    private final Runnable changed;
    private Optional<CoverageSkinning.Shown> shown = Optional.empty();
    private Optional<Position> place = Optional.empty();
    private Optional<Cell> cell = Optional.empty();

    /** The coverage that the thread examines; only the thread uses it. */
    private FieldCoverage examined;

    private CellExaminer examiner;

    /**
     * A cell.
     *
     * @param evidence the evidence; empty until the cell has been assessed, and in cells where the drone cannot be
     */
    record Cell(FieldCoverage coverage, int height, SkinCell at, CellWords words, Optional<CellEvidence> evidence) {
        boolean is(FieldCoverage other, int otherHeight, SkinCell otherAt) {
            return coverage == other && height == otherHeight && at.equals(otherAt);
        }
    }

    /**
     * No cell.
     *
     * @param changed called on the event thread when more, or something else, is known
     * @param failed receives what went wrong
     */
    PointedCell(Runnable changed, Consumer<Throwable> failed) {
        this.thread = new Latest("dronewatch-cell", 1, failed);
        this.changed = changed;
    }

    /** Takes another coverage, or none; the pointer stays where it is. */
    void show(Optional<CoverageSkinning.Shown> next) {
        shown = next;
        update();
    }

    /** Moves the pointer to another point of the site, or to none. */
    void point(Optional<Position> next) {
        place = next;
        update();
    }

    private void update() {
        Optional<SkinCell> at =
                place.flatMap(point -> shown.flatMap(now -> now.skin().cellAt(point)));
        if (at.isEmpty()) {
            cell = Optional.empty();
            changed.run();
            return;
        }
        CoverageSkinning.Shown now = shown.orElseThrow();
        int height = now.remaining().height();
        if (cell.filter(one -> one.is(now.rest(), height, at.get())).isEmpty()) {
            examine(now, height, at.get());
        }
    }

    private void examine(CoverageSkinning.Shown now, int height, SkinCell at) {
        CellWords words = new CellWords(now.rest(), now.coverage().request().settings(), height, at.column(), at.row());
        Cell next = new Cell(now.rest(), height, at, words, Optional.empty());
        cell = Optional.of(next);
        changed.run();
        thread.ask(outdated -> {
            if (examined != now.rest()) {
                examined = now.rest();
                examiner = new CellExaminer(now.rest(), now.coverage().request().stage());
            }
            Optional<CellEvidence> evidence = examiner.examine(height, at.column(), at.row());
            SwingUtilities.invokeLater(() -> {
                if (cell.filter(one -> one == next).isPresent()) {
                    cell = Optional.of(new Cell(now.rest(), height, at, words, evidence));
                    changed.run();
                }
            });
        });
    }

    /** The cell; empty where there is none. */
    Optional<Cell> cell() {
        return cell;
    }

    boolean isIdle() {
        return thread.isIdle();
    }

    @Override
    public void close() {
        thread.close();
    }
}
