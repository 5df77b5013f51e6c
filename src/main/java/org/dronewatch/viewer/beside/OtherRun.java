package org.dronewatch.viewer.beside;

import org.dronewatch.viewer.run.RecordedRun;

/**
 * A run with which the displayed run can be compared.
 *
 * @param name under which users select it, such as {@code before the change}
 * @param run the run, of which only the part simulated so far is recorded
 */
public record OtherRun(String name, RecordedRun run) {
    /** The name of the run, as a list shows it. */
    @Override
    public String toString() {
        return name;
    }
}
