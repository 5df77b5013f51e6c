package org.dronewatch.analysis.layer;

import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.FieldColumns;

/**
 * Reports how far the tracing of a sensor's levels has progressed, as a number of cells of the field: all positions at
 * which levels are traced together count as much as all cells, since tracing takes most of the time. Thread-safe.
 */
final class SurveyProgress {
    private final IntConsumer progress;
    private final long whole;
    private long traced;
    private long reported;

    private SurveyProgress(long whole, IntConsumer progress) {
        this.whole = whole;
        this.progress = progress;
    }

    /**
     * The progress of the survey of one sensor: nothing for one whose signal is not interpolated.
     *
     * @param progress receives the number of cells that the positions represent since the last call
     */
    static SurveyProgress of(FieldProbe probe, FieldColumns columns, IntConsumer progress) {
        long cells = (long) columns.columns() * columns.rows() * columns.levels();
        return new SurveyProgress(ExcessSurvey.isPossible(probe) ? cells : 0, progress);
    }

    /** Another position has been traced, of a number of them. */
    synchronized void traced(int of) {
        traced++;
        report(Math.min(whole, whole * traced / of));
    }

    /** There are no more positions. */
    synchronized void finish() {
        report(whole);
    }

    private void report(long cells) {
        if (cells > reported) {
            progress.accept((int) (cells - reported));
            reported = cells;
        }
    }
}
