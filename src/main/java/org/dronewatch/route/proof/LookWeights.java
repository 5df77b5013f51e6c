package org.dronewatch.route.proof;

import java.util.List;
import org.dronewatch.sensor.Chance;

/**
 * By how much the probability that a drone is detected on a flight changes with that of each look: the derivative,
 * which is the probability that all other looks miss the drone.
 *
 * @param each weight of each look, in the order of the schedule; 0 for looks that do not matter
 * @param detection the probability that the drone is detected
 */
record LookWeights(double[] each, double detection) {
    /**
     * The weights for a detection early enough.
     *
     * @param left time that must be left at the end of the flight, 0 or more, s
     */
    static LookWeights of(BegunFlight flight, double left) {
        LookSchedule schedule = flight.schedule();
        double until = flight.settings().run().duration() - left;
        List<ScheduledLook> looks = schedule.looks();
        double[] weights = new double[looks.size()];
        double missed = ofObservers(schedule, until);
        for (int i = 0; i < weights.length; i++) {
            weights[i] = matters(looks.get(i), schedule, until) ? missed : 0.0;
            missed *= missed(looks.get(i), schedule, until);
        }
        double detection = 1.0 - missed;
        double missedLater = 1.0;
        for (int i = weights.length - 1; i >= 0; i--) {
            weights[i] *= missedLater;
            missedLater *= missed(looks.get(i), schedule, until);
        }
        return new LookWeights(weights, detection);
    }

    private static double ofObservers(LookSchedule schedule, double until) {
        double missed = 1.0;
        for (int sensor = 0; sensor < schedule.sensors().size(); sensor++) {
            if (schedule.sensors().get(sensor).chance() == Chance.PER_ENCOUNTER) {
                missed *= schedule.missed(sensor, until, MissedLooks.Wait.SEEN);
            }
        }
        return missed;
    }

    private static boolean matters(ScheduledLook look, LookSchedule schedule, double until) {
        return look.time() <= until && schedule.sensors().get(look.number()).chance() == Chance.PER_LOOK;
    }

    private static double missed(ScheduledLook look, LookSchedule schedule, double until) {
        return matters(look, schedule, until) ? 1.0 - look.probability() : 1.0;
    }
}
