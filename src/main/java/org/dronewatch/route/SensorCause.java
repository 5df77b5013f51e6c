package org.dronewatch.route;

import java.util.List;
import org.dronewatch.sensor.Cause;

/**
 * Why a sensor does not detect a drone on a leg in one cell.
 *
 * @param sensor its name
 * @param step the probability that one of its looks detects the drone, as a step
 * @param cause its cause
 */
record SensorCause(String sensor, int step, Cause cause) {
    /**
     * The cause of the sensor with the highest probability; in a tie, the one that is nearest to a detection. Without
     * a sensor, nothing is known.
     */
    static Cause dominant(List<SensorCause> causes) {
        Cause dominant = Cause.UNKNOWN;
        int most = -1;
        for (SensorCause one : causes) {
            if (one.step > most || one.step == most && one.cause.compareTo(dominant) > 0) {
                dominant = one.cause;
                most = one.step;
            }
        }
        return dominant;
    }
}
