package org.dronewatch.viewer.coverage;

import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.SwingUtilities;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.viewer.part.Latest;
import org.dronewatch.viewer.run.ViewedRun;

/**
 * Computes coverages on a separate thread, one at a time, as the {@code coverage} command does and with the results
 * that it has kept.
 */
final class CoverageComputing implements AutoCloseable {
    private final Latest thread;
    private final Function<SceneSettings, LayerStore> stores;
    private final AtomicLong looks = new AtomicLong();
    private volatile long expected = 1;

    /** Whether the computation that was requested last is cancelled. */
    private AtomicBoolean cancelled = new AtomicBoolean();

    /**
     * Creates the thread; nothing is computed yet.
     *
     * @param threads number of threads that may help
     * @param stores returns the store of what was computed before
     * @param failed receives what went wrong
     */
    CoverageComputing(int threads, Function<SceneSettings, LayerStore> stores, Consumer<Throwable> failed) {
        this.thread = new Latest("dronewatch-coverage", threads, failed);
        this.stores = stores;
    }

    /**
     * Computes a coverage.
     *
     * @param settings settings of the run, perhaps with some of its sensors moved or turned
     * @param target receives the coverage on the event thread; after a cancellation, only the heights that are
     *     complete; empty if none is complete, or after a failure
     */
    void compute(
            ViewedRun run,
            SceneSettings settings,
            CoverageForm.Inputs inputs,
            Consumer<Optional<ViewedCoverage>> target) {
        looks.set(0);
        expected = 1;
        AtomicBoolean its = new AtomicBoolean();
        cancelled = its;
        thread.ask(outdated -> {
            Optional<ViewedCoverage> result = Optional.empty();
            try {
                result = compute(run, settings, inputs, () -> its.get() || outdated.getAsBoolean());
            } finally {
                Optional<ViewedCoverage> shown = result;
                SwingUtilities.invokeLater(() -> target.accept(shown));
            }
        });
    }

    private Optional<ViewedCoverage> compute(
            ViewedRun run, SceneSettings settings, CoverageForm.Inputs inputs, BooleanSupplier ended) {
        FieldRequest request = new FieldRequest(
                settings,
                run.stage(),
                inputs.drone(),
                inputs.grid(),
                inputs.heading().courses(settings, run.stage(), inputs.drone(), inputs.grid()),
                inputs.heading().choice(),
                FieldTerms.ONE_LOOK,
                FieldCoverage.DEFAULT_COVERED);
        expected = Math.max(1, request.looksOfField());
        LayerStore store = stores.apply(run.settings());
        return FieldAssessment.untilInterrupted(request, store, cells -> {
                    if (ended.getAsBoolean()) {
                        throw new CancellationException("cancelled");
                    }
                    looks.addAndGet(cells);
                })
                .map(field -> new ViewedCoverage(request, field));
    }

    /** Ends the computation early. */
    void cancel() {
        // This is not done by another request: a computation that has not begun would be dropped, and its end not
        // reported.
        cancelled.set(true);
    }

    /** The fraction that is done, 0 to 1. */
    double progress() {
        return Math.min(1.0, (double) looks.get() / expected);
    }

    boolean isIdle() {
        return thread.isIdle();
    }

    @Override
    public void close() {
        thread.close();
    }
}
