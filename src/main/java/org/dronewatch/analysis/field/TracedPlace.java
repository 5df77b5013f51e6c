package org.dronewatch.analysis.field;

import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.InterpolableSensor;
import org.dronewatch.sensor.Signal;

/**
 * A position at which a drone was assessed with all rays.
 *
 * @param at the position, m
 * @param isInSight whether nothing is in the way of the direct signal
 * @param signal the signal
 * @param overOpen by how much that exceeds the signal in the open, dB
 * @param overExact by how much it exceeds the signal on exact paths, dB
 */
record TracedPlace(Position at, boolean isInSight, Signal signal, double overOpen, double overExact) {
    /** A signal that is weaker than this compared with the open counts as this weak, dB: it may be silence. */
    private static final double WEAKEST = -60.0;

    /** Assesses a drone. */
    static TracedPlace of(FieldProbe probe, Assessor assessor, Drone there) {
        InterpolableSensor sensor = assessor.interpolable().orElseThrow();
        Signal open = sensor.signalInTheOpen(probe.world(), there).orElseThrow();
        Signal exact = sensor.signalOnExactPaths(probe.world(), there);
        Signal signal =
                probe.assess(assessor, there, probe.pointing(there.origin())).signal();
        return new TracedPlace(
                there.origin(),
                sensor.isInSight(probe.world(), there),
                signal,
                over(open, signal),
                over(open, signal) - over(open, exact));
    }

    /** By how much a signal exceeds that in the open, dB. */
    static double over(Signal open, Signal signal) {
        return Math.max(signal.quantity() - open.quantity(), WEAKEST);
    }
}
