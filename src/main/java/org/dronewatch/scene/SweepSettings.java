package org.dronewatch.scene;

import java.util.List;
import org.dronewatch.setting.Check;

/**
 * A setting that takes one value after another, a run for each.
 *
 * @param parameter path of the setting, such as {@code sensors.camera.fov}
 * @param values what it takes, written as for {@code --set}; 1 to 10,000
 */
public record SweepSettings(String parameter, List<String> values) {
    private static final int MAX_RUNS = 10_000;

    /** Checks the limits and keeps its own list. */
    public SweepSettings {
        Check.present("parameter", parameter);
        values = List.copyOf(Check.present("values", values));
        if (values.isEmpty() || values.size() > MAX_RUNS) {
            throw new IllegalArgumentException("values has " + values.size() + " entries, must have 1 to " + MAX_RUNS);
        }
    }
}
