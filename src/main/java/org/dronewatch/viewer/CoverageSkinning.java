package org.dronewatch.viewer;

import java.util.List;
import java.util.Set;
import java.util.function.Consumer;
import javax.swing.SwingUtilities;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.RemainingCoverage;
import org.dronewatch.report.coverage.CoverageSkin;
import org.dronewatch.report.coverage.CoverageSkin.LegendEntry;

/** Makes skins of a coverage on a thread: at a height, without the sensors that are switched off. */
final class CoverageSkinning implements AutoCloseable {
    private final Latest thread;

    /** What is shown of a coverage. */
    record Shown(
            ViewedCoverage coverage,
            Set<String> off,
            RemainingCoverage remaining,
            CoverageSkin skin,
            List<LegendEntry> legend) {
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
     * @param height its number
     * @param off the sensors that are switched off
     * @param target receives it on the event thread, unless another one has been requested
     */
    void lay(ViewedCoverage coverage, int height, Set<String> off, Consumer<Shown> target) {
        thread.ask(outdated -> {
            RemainingCoverage remaining = RemainingCoverage.of(coverage.all(), coverage.without(off), height);
            CoverageSkin skin = new CoverageSkin(remaining);
            Shown shown = new Shown(coverage, off, remaining, skin, skin.legend());
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
