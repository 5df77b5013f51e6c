package org.dronewatch.analysis.layer;

import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.InterpolableSensor;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sound.Levels;

/**
 * A position at which a drone was assessed with all rays.
 *
 * @param at the position, m
 * @param isInSight whether nothing is in the way of the direct signal
 * @param signal the signal
 * @param overOpen by how much it exceeds the signal in the open, dB
 * @param exact by how much the signal along exact paths exceeds the signal in the open, dB
 * @param rest what arrives along other paths, dB
 */
record TracedPlace(Position at, boolean isInSight, Signal signal, double overOpen, double exact, double rest) {
    /** A signal that is weaker than this relative to that in the open counts as this weak, dB: it may be silence. */
    private static final double WEAKEST = -60.0;

    /** Assesses a drone. */
    static TracedPlace of(FieldProbe probe, Assessor assessor, Drone there) {
        InterpolableSensor sensor = assessor.interpolable().orElseThrow();
        Signal open = sensor.signalInTheOpen(probe.world(), there).orElseThrow();
        Signal exact = sensor.signalOnExactPaths(probe.world(), there);
        Signal signal =
                probe.assess(assessor, there, probe.pointing(there.origin())).signal();
        double overOpen = over(open, signal);
        double ofExact = over(open, exact);
        return new TracedPlace(
                there.origin(),
                sensor.isInSight(probe.world(), there),
                signal,
                overOpen,
                ofExact,
                open.quantity() + rest(overOpen, ofExact));
    }

    /** What all paths add to the exact ones; all relative to the signal in the open, dB. */
    private static double rest(double overOpen, double exact) {
        double energy = Levels.toRatio(overOpen) - (isSilent(exact) ? 0.0 : Levels.toRatio(exact));
        return energy > 0.0 ? Math.max(Levels.ofRatio(energy), WEAKEST) : WEAKEST;
    }

    /** Whether a signal, relative to that in the open, dB, may be silence. */
    static boolean isSilent(double over) {
        return over <= WEAKEST;
    }

    /** What arrives along exact and other paths together; all relative to the signal in the open, dB. */
    static double together(double exact, double rest) {
        double all = isSilent(exact) ? rest : Levels.ofRatio(Levels.toRatio(exact) + Levels.toRatio(rest));
        return Math.max(all, WEAKEST);
    }

    /** The signal in the open, dB. */
    double open() {
        return rest - rest(overOpen, exact);
    }

    /** By how much a signal exceeds that in the open, dB. */
    static double over(Signal open, Signal signal) {
        return Math.max(signal.quantity() - open.quantity(), WEAKEST);
    }
}
