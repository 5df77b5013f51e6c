package org.dronewatch.campaign.outcome;

import java.util.Optional;

/** The outcome for one drone in a case. */
public enum DroneOutcome {
    /** No sensor detects the drone. */
    MISSED(false, false, Optional.empty()),
    /** The drone is detected, but there is no alert for it. */
    DETECTED(true, false, Optional.empty()),
    /** There is an alert, and no response time is required. */
    ALERTED(true, true, Optional.empty()),
    /** There is an alert, but it leaves less time than the response requires. */
    LATE(true, true, Optional.of(false)),
    /** There is an alert that leaves enough time for the response. */
    IN_TIME(true, true, Optional.of(true));

    private final boolean isDetected;
    private final boolean isAlerted;
    private final Optional<Boolean> isInTime;

    DroneOutcome(boolean isDetected, boolean isAlerted, Optional<Boolean> isInTime) {
        this.isDetected = isDetected;
        this.isAlerted = isAlerted;
        this.isInTime = isInTime;
    }

    /** The outcome for a drone that is detected or not, and for which there is an alert or not, in time or not. */
    public static DroneOutcome of(boolean isDetected, boolean isAlerted, Optional<Boolean> isInTime) {
        if (!isAlerted) {
            return isDetected ? DETECTED : MISSED;
        }
        return isInTime.map(yes -> yes ? IN_TIME : LATE).orElse(ALERTED);
    }

    /** Whether this drone has the given outcome. */
    boolean has(Outcome outcome) {
        return switch (outcome) {
            case DETECTED -> isDetected;
            case ALERTED -> isAlerted;
            case IN_TIME -> isInTime.orElse(false);
        };
    }
}
