package org.dronewatch.viewer.coverage;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.survey.RemainingCoverage;
import org.dronewatch.report.coverage.CoverageSkin;
import org.dronewatch.report.coverage.CoverageSkin.LegendEntry;
import org.dronewatch.report.coverage.table.LossWords;
import org.dronewatch.report.coverage.table.MoveWords;
import org.dronewatch.viewer.part.Latest;

/**
 * Computes, on a separate thread, the overlays (skins) that show a coverage at one height, without the sensors that are
 * switched off.
 */
public final class CoverageSkinning implements AutoCloseable {
    private final Latest thread;

    /**
     * What is shown of a coverage.
     *
     * @param off the sensors that are switched off
     * @param words what is covered, in words
     * @param fineness fineness of what is shown while sensors are moved; empty if none was moved
     */
    public record Shown(
            ViewedCoverage coverage,
            Set<String> off,
            RemainingCoverage remaining,
            CoverageSkin skin,
            List<LegendEntry> legend,
            String words,
            Optional<MoveWords.Fineness> fineness) {
        static Shown of(
                ViewedCoverage coverage,
                Set<String> off,
                RemainingCoverage remaining,
                String words,
                Optional<MoveWords.Fineness> fineness) {
            CoverageSkin skin = new CoverageSkin(remaining);
            return new Shown(coverage, off, remaining, skin, skin.legend(), words, fineness);
        }

        /** The coverage of the sensors that are switched on. */
        FieldCoverage rest() {
            return remaining.rest();
        }
    }

    CoverageSkinning(int threads, Consumer<Throwable> failed) {
        this.thread = new Latest("dronewatch-skin", threads, failed);
    }

    /**
     * Makes a skin.
     *
     * @param height index of the height
     * @param off the sensors that are switched off
     * @param target receives it on the event thread, unless another one has been requested
     */
    void lay(ViewedCoverage coverage, int height, Set<String> off, Consumer<Shown> target) {
        thread.ask(outdated -> {
            RemainingCoverage remaining = RemainingCoverage.of(coverage.all(), coverage.without(off), height);
            String words = LossWords.sentence(remaining, off) + coverage.missing();
            Shown shown = Shown.of(coverage, off, remaining, words, Optional.empty());
            SwingUtilities.invokeLater(() -> {
                if (!outdated.getAsBoolean()) {
                    target.accept(shown);
                }
            });
        });
    }

    boolean isIdle() {
        return thread.isIdle();
    }

    @Override
    public void close() {
        thread.close();
    }
}
