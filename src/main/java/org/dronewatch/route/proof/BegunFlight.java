package org.dronewatch.route.proof;

import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.world.World;

/**
 * A route as it is flown from one of several moments on.
 *
 * @param settings of the scene in which the drone begins it then
 * @param world of the scene
 * @param schedule the looks at the drone
 */
record BegunFlight(SceneSettings settings, World world, LookSchedule schedule) {
    /** The probability that the drone is detected, 0 to 1. */
    double detection(MissedLooks.Wait wait) {
        return 1.0 - schedule.missed(settings.run().duration(), wait);
    }

    /** The same by one sensor, given by its number, as if it were the only one. */
    double detection(int sensor, MissedLooks.Wait wait) {
        return 1.0 - schedule.missed(sensor, settings.run().duration(), wait);
    }
}
