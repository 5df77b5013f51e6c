package org.dronewatch.run;

import java.util.function.BooleanSupplier;
import org.dronewatch.run.time.LookTimes;
import org.dronewatch.run.time.Pace;

/**
 * The control of a run: its end, its pace, and the record of its computing time. None of this changes the results up to
 * the end of the run.
 *
 * @param until the last time at which sensors may look, seconds since the start of the run; infinite if the caller ends
 *     the run
 * @param pace waits before each look
 * @param cancelled queried before each look: once it is true, no more looks are taken
 * @param times records the computing time of the sensors' looks
 */
public record RunControl(double until, Pace pace, BooleanSupplier cancelled, LookTimes times) {

    /** Runs to a time, s, as fast as possible. */
    public static RunControl until(double seconds) {
        return new RunControl(seconds, Pace.AS_FAST_AS_POSSIBLE, () -> false, new LookTimes());
    }

    /** This control with another end of the run, s. */
    public RunControl withUntil(double seconds) {
        return new RunControl(seconds, pace, cancelled, times);
    }
}
