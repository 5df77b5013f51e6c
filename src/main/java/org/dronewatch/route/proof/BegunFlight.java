package org.dronewatch.route.proof;

import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.world.World;

/**
 * A route as it is flown if it begins at one of several moments.
 *
 * @param settings settings of the scene in which the drone begins the route at that moment
 * @param world the scene's world
 * @param schedule the looks at the drone
 */
record BegunFlight(SceneSettings settings, World world, LookSchedule schedule) {
    /** The probability that the drone is detected, 0 to 1. */
    double detection(MissedLooks.Wait wait) {
        return 1.0 - schedule.missed(settings.run().duration(), wait);
    }

    /** The probability that one sensor, given by its number, detects the drone, as if it were the only one. */
    double detection(int sensor, MissedLooks.Wait wait) {
        return 1.0 - schedule.missed(sensor, settings.run().duration(), wait);
    }

    /**
     * The last moment at which an alert leaves enough time for the scene's response, s since the start of the run; it
     * may be negative.
     */
    double critical() {
        return settings.run().duration() - settings.alert().response();
    }

    /**
     * The probability that an alert is raised at or before the {@link #critical} moment, 0 to 1, if observers search
     * for the drone while it waits.
     *
     * @throws java.util.NoSuchElementException if it cannot be computed ({@link AlertChances#isKnown})
     */
    double alertInTime() {
        return AlertChances.of(schedule, settings.alert(), MissedLooks.Wait.SEEN)
                .orElseThrow()
                .by(critical());
    }

    /** This flight with more estimates of the looks; see {@link LookSchedule#withEstimates}. */
    BegunFlight withEstimates(int[] counts) {
        return new BegunFlight(settings, world, schedule.withEstimates(settings, world, counts));
    }
}
