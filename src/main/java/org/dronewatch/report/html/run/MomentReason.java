package org.dronewatch.report.html.run;

import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.Signal;

/**
 * Why a sensor does not detect a drone at a moment of a run.
 *
 * @param explanation the cause with its evidence; {@link Explanation#DETECTED} where the sensor could detect the drone
 * @param words the cause in words, without its evidence
 */
record MomentReason(Explanation explanation, String words) {
    /** The reason for a drone that the sensor never detects. */
    static MomentReason ofMiss(Assessor assessor, Drone drone, Optional<Pointing> pointing, String weak) {
        Explanation explanation = assessor.explainMiss(drone, pointing);
        return new MomentReason(explanation, CauseWords.of(explanation, drone, weak));
    }

    /**
     * The reason for a drone that the sensor detects at other times. If a look at this moment might detect the drone,
     * the reason is chance, or that there is no look at this moment.
     *
     * @param hasObserved whether the sensor has observed the drone before, detected or not
     */
    static MomentReason ofGap(
            Assessor assessor,
            SensorSettings<?> settings,
            Drone drone,
            Optional<Pointing> pointing,
            Look look,
            boolean hasObserved) {
        String weak = settings.description().weakness();
        MomentReason missed = ofMiss(assessor, drone, pointing, weak);
        Cause cause = missed.explanation().cause();
        // Rays would have to be traced to find out whether sound that has to pass an obstacle is loud enough.
        boolean mayBePassed = cause.isHidden() && assessor.interpolable().isEmpty();
        if (cause != Cause.TOO_WEAK && !mayBePassed) {
            return missed;
        }
        Optional<Signal> open = assessor.signalInTheOpen(drone);
        if (open.isPresent()) {
            return open.get().isDetected() ? ofDetectable(settings, open.get().probability(), hasObserved) : missed;
        }
        Assessment there = assessor.assess(drone, pointing, look.random(drone.id(), RaySensor.RAYS));
        return there.cause() == Cause.DETECTED
                ? ofDetectable(settings, there.probability(), hasObserved)
                : new MomentReason(there.explanation(), CauseWords.of(there.explanation(), drone, weak));
    }

    private static MomentReason ofDetectable(SensorSettings<?> settings, double probability, boolean hasObserved) {
        String words = !hasObserved
                ? "before the first look at the drone"
                : probability == 1.0
                        ? "between looks"
                        : settings.chance() == Chance.PER_ENCOUNTER
                                ? "not found by the observer"
                                : "missed by chance or between looks";
        return new MomentReason(Explanation.DETECTED, words);
    }
}
