package org.dronewatch.placement.site;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.field.FieldHeading;
import org.dronewatch.analysis.survey.FieldSummary;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;

/**
 * The coverage of the best layout and that of the scene's own sensors in the same cells, each as {@code coverage} finds
 * it.
 *
 * @param heading the heading that counts in a cell
 * @param layout coverage of the layout
 * @param settings the scene with only the layout's sensors
 * @param present coverage of the scene's own sensors; empty if it has none
 */
public record LayoutFields(
        FieldHeading heading, FieldSummary layout, SceneSettings settings, Optional<FieldSummary> present) {
    /**
     * Assesses both layouts on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param progress receives the number of cells that were assessed since the last call
     * @return empty if the layout has no sensor, or this thread is interrupted; it then stays interrupted
     */
    public static Optional<LayoutFields> of(SitePlacement placement, CoveredCells cells, IntConsumer progress) {
        Map<String, SensorSettings<?>> chosen = Layout.sensors(placement.chosen());
        Map<String, SensorSettings<?>> own = placement.plan().present().enabledSensors();
        if (chosen.isEmpty()) {
            return Optional.empty();
        }
        try {
            FieldSummary layout = cells.summary(chosen, progress);
            Optional<FieldSummary> present =
                    own.isEmpty() ? Optional.empty() : Optional.of(cells.summary(own, progress));
            return Optional.of(new LayoutFields(cells.heading(), layout, cells.alone(chosen), present));
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }

    /**
     * The fraction of the known cells, over all heights, that a layout covers.
     *
     * @param fold number of sensors that must cover a cell, 1 or more
     */
    public static double share(FieldSummary summary, int fold) {
        long known = 0;
        long covered = 0;
        for (var height : summary.heights()) {
            known += height.known();
            for (int sensors = fold; sensors < height.counts().length; sensors++) {
                covered += height.counts()[sensors];
            }
        }
        return known == 0 ? 0.0 : (double) covered / known;
    }
}
