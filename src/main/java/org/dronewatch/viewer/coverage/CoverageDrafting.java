package org.dronewatch.viewer.coverage;

import java.util.Optional;
import java.util.Set;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.dronewatch.analysis.field.FieldDraft;
import org.dronewatch.analysis.survey.RemainingCoverage;
import org.dronewatch.report.coverage.table.MoveWords;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.viewer.part.Latest;

/**
 * Draws what is covered at one height anew while sensors are moved, on a separate thread: at once a coarse picture,
 * which is never abandoned, then finer ones until the sensors move on.
 */
final class CoverageDrafting implements AutoCloseable {
    /** The first picture is not made finer if that is expected to take longer than this, s. */
    private static final double FIRST = 0.02;

    /** The least time between two pictures of the same layout, s. */
    private static final double PAUSE = 0.3;

    /** The first picture has the cores to itself until it is painted or sensors move on, for at most this time, s. */
    private static final double PAINTING = 0.1;

    private static final double NANO = 1e-9;

    /** The time between two queries of whether the picture is painted, ns. */
    private static final long POLL = 500_000;

    private final Latest thread;
    private final BooleanSupplier isPainting;

    /**
     * Creates the thread; nothing is drawn yet.
     *
     * @param threads number of threads that may help
     * @param isPainting whether a picture is being painted, from any thread
     * @param failed receives what went wrong
     */
    CoverageDrafting(int threads, BooleanSupplier isPainting, Consumer<Throwable> failed) {
        this.isPainting = isPainting;
        this.thread = new Latest("dronewatch-draft", threads, failed);
    }

    /**
     * Draws a coverage with some of its sensors moved or turned.
     *
     * @param before the coverage that was computed
     * @param height index of the height
     * @param off the sensors that are switched off
     * @param moved the settings with the sensors where they are now
     * @param target receives one picture after the other on the event thread
     */
    void draft(
            ViewedCoverage before,
            int height,
            Set<String> off,
            SceneSettings moved,
            Consumer<CoverageSkinning.Shown> target) {
        thread.ask(outdated -> {
            RemainingCoverage former = RemainingCoverage.of(before.all(), before.without(off), height);
            new Drawing(before, former, off, moved, target, isPainting, outdated).draw();
        });
    }

    /** Stops drawing, because no sensor is displaced any longer. */
    void stop() {
        thread.ask(outdated -> {});
    }

    boolean isIdle() {
        return thread.isIdle();
    }

    @Override
    public void close() {
        thread.close();
    }

    /** The pictures of one layout. */
    private record Drawing(
            ViewedCoverage before,
            RemainingCoverage former,
            Set<String> off,
            SceneSettings moved,
            Consumer<CoverageSkinning.Shown> target,
            BooleanSupplier isPainting,
            BooleanSupplier outdated) {
        void draw() {
            FieldDraft draft = new FieldDraft(before.request(), before.all().field(), former.height(), moved);
            long start = System.nanoTime();
            draft.begin();
            double each = seconds(start) / Math.max(1, draft.assessed());
            while (!draft.isFine() && seconds(start) + each * draft.next() < FIRST) {
                draft.refine(() -> false);
            }
            awaitPainted(publish(draft));
            refine(draft);
            if (!outdated.getAsBoolean()) {
                draft.complete(outdated);
            }
            if (draft.isComplete()) {
                publish(draft);
            }
        }

        private void awaitPainted(AtomicBoolean isTaken) {
            long since = System.nanoTime();
            while (!outdated.getAsBoolean()
                    && (!isTaken.get() || isPainting.getAsBoolean())
                    && seconds(since) < PAINTING) {
                LockSupport.parkNanos(POLL);
            }
        }

        private void refine(FieldDraft draft) {
            long last = System.nanoTime();
            boolean isNew = false;
            while (!draft.isFine() && !outdated.getAsBoolean()) {
                draft.refine(outdated);
                isNew = !outdated.getAsBoolean();
                if (isNew && seconds(last) > PAUSE) {
                    publish(draft);
                    isNew = false;
                    last = System.nanoTime();
                }
            }
            if (isNew) {
                publish(draft);
            }
        }

        /** Hands a picture to the target; what is returned becomes true once it has been accepted. */
        private AtomicBoolean publish(FieldDraft draft) {
            ViewedCoverage now = new ViewedCoverage(draft.request(before.request(), moved), draft.field());
            RemainingCoverage remaining = RemainingCoverage.of(now.all(), now.without(off), 0);
            MoveWords.Fineness fineness = draft.isComplete()
                    ? MoveWords.Fineness.COMPLETE
                    : draft.isFine() ? MoveWords.Fineness.FINE : MoveWords.Fineness.COARSE;
            String words = MoveWords.sentence(
                    former,
                    remaining,
                    off,
                    FieldDraft.movedSensors(before.all().field(), moved),
                    fineness,
                    draft.reduced());
            CoverageSkinning.Shown shown = CoverageSkinning.Shown.of(now, off, remaining, words, Optional.of(fineness));
            AtomicBoolean isTaken = new AtomicBoolean();
            SwingUtilities.invokeLater(() -> {
                target.accept(shown);
                isTaken.set(true);
            });
            return isTaken;
        }

        private static double seconds(long since) {
            return NANO * (System.nanoTime() - since);
        }
    }
}
