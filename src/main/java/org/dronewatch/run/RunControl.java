package org.dronewatch.run;

import java.util.function.BooleanSupplier;

/**
 * How a run is driven: when it ends, how fast it goes, and who notes how long that takes. Nothing of it changes what is
 * computed up to where the run ends.
 *
 * @param until the last time at which sensors may look, seconds since the start of the run; infinite if whoever drives the run
 *     ends it
 * @param pace keeps time before each look
 * @param cancelled is asked before each look: once it is true, there are no more
 * @param times notes how long the sensors look
 */
public record RunControl(double until, Pace pace, BooleanSupplier cancelled, LookTimes times) {

    /** To a time, as fast as possible. */
    public static RunControl until(double seconds) {
        return new RunControl(seconds, Pace.AS_FAST_AS_POSSIBLE, () -> false, new LookTimes());
    }

    /** The same to another time. */
    public RunControl withUntil(double seconds) {
        return new RunControl(seconds, pace, cancelled, times);
    }
}
