package org.dronewatch.render.canvas;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;

/**
 * A drone as drawn in a view.
 *
 * @param drone the drone as it is now
 * @param flown path of the drone up to now
 * @param toCome path of the drone from now on
 * @param detected whether a sensor detects it now
 */
public record DroneMark(Drone drone, List<Position> flown, List<Position> toCome, boolean detected) {
    /** Copies the lists: later changes by the caller have no effect. */
    public DroneMark {
        flown = List.copyOf(flown);
        toCome = List.copyOf(toCome);
    }
}
