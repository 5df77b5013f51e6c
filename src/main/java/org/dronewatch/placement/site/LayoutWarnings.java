package org.dronewatch.placement.site;

import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;

/**
 * The warning times of the best layout and those of the scene's own sensors, for the same flights, both as
 * {@code coverage} finds them.
 *
 * @param layout warning times of the layout
 * @param settings the scene with only the layout's sensors
 * @param present warning times of the scene's own sensors; empty if the scene has none
 */
public record LayoutWarnings(InboundWarnings layout, SceneSettings settings, Optional<InboundWarnings> present) {
    /**
     * Assesses both layouts on the {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param progress receives the number of cells that were assessed since the last call
     * @return empty if the layout has no sensor, or this thread is interrupted; it then stays interrupted
     */
    static Optional<LayoutWarnings> of(WarningPlacement placement, WarningFlights flights, IntConsumer progress) {
        PlacePlan plan = placement.plan();
        Map<String, SensorSettings<?>> chosen = Layout.sensors(placement.chosen());
        Map<String, SensorSettings<?>> own = plan.present().enabledSensors();
        if (chosen.isEmpty()) {
            return Optional.empty();
        }
        try {
            InboundWarnings layout = flights.of(chosen, progress);
            Optional<InboundWarnings> present =
                    own.isEmpty() ? Optional.empty() : Optional.of(flights.of(own, progress));
            return Optional.of(new LayoutWarnings(layout, Layout.alone(plan.present(), chosen), present));
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }
}
