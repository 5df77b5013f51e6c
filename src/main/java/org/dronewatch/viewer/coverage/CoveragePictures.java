package org.dronewatch.viewer.coverage;

import java.util.Set;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.dronewatch.scenario.SceneSettings;

/** Makes pictures of a coverage: as it was computed or, while sensors are moved, drawn anew. For the event thread. */
final class CoveragePictures implements AutoCloseable {
    private final CoverageSkinning skinning;
    private final CoverageDrafting drafting;
    private View wanted;

    /** What is to be shown. */
    private record View(ViewedCoverage coverage, int height, Set<String> off, boolean isDraft) {}

    CoveragePictures(int threads, BooleanSupplier isPainting, Consumer<Throwable> failed) {
        this.skinning = new CoverageSkinning(threads, failed);
        this.drafting = new CoverageDrafting(threads, isPainting, failed);
    }

    /**
     * Makes pictures.
     *
     * @param height index of the height
     * @param off the sensors that are switched off
     * @param settings the settings with the sensors where they are now
     * @param target receives them on the event thread, one after the other, until something else is wanted
     */
    void show(
            ViewedCoverage coverage,
            int height,
            Set<String> off,
            SceneSettings settings,
            Consumer<CoverageSkinning.Shown> target) {
        View view = new View(coverage, height, off, coverage.isMoved(settings));
        wanted = view;
        // While a sensor is dragged, a picture of where it was a moment ago is better than none.
        Consumer<CoverageSkinning.Shown> ifWanted = next -> {
            if (view.equals(wanted)) {
                target.accept(next);
            }
        };
        if (view.isDraft()) {
            drafting.draft(coverage, height, off, settings, ifWanted);
        } else {
            drafting.stop();
            skinning.lay(coverage, height, off, ifWanted);
        }
    }

    /** Stops making pictures, because none are wanted any more. */
    void stop() {
        wanted = null;
        drafting.stop();
    }

    boolean isIdle() {
        return skinning.isIdle() && drafting.isIdle();
    }

    @Override
    public void close() {
        skinning.close();
        drafting.close();
    }
}
