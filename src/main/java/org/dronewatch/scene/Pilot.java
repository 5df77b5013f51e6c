package org.dronewatch.scene;

/**
 * Steers, in one run, the drones whose flight is {@code steered}. Each run of a sweep and each replication gets a new
 * pilot without any state, so a run does not depend on those before it.
 *
 * <p>At the beginning of the run, a pilot gives its first commands and schedules events at which it will give more. A
 * command takes effect before the looks of sensors at the same time, since looks have DSOL's lowest priority.
 */
@FunctionalInterface
public interface Pilot {
    /** A pilot that gives no commands. */
    Pilot NONE = run -> {};

    /** Called once, at time 0 of the run, before any sensor looks. */
    void begin(PilotedRun run);
}
