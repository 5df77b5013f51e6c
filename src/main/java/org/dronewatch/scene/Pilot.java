package org.dronewatch.scene;

/**
 * Steers the drones of one run whose flight is {@code steered}. Each run gets a new pilot, so whatever a pilot
 * remembers begins anew with each run of a sweep and each replication, and a run does not depend on what ran before it.
 *
 * <p>A pilot acts through the run's simulator: at the beginning it gives its first commands and schedules the events at
 * which it will give more. A command at some time counts before sensors look at that time, since looks have DSOL's lowest
 * priority.
 */
@FunctionalInterface
public interface Pilot {
    /** Nobody steers. */
    Pilot NONE = run -> {};

    /** Called once, at time 0 of the run, before any sensor looks. */
    void begin(PilotedRun run);
}
