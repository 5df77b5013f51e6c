package org.dronewatch.campaign.outcome;

import java.util.function.Predicate;

/** Something that a case has or lacks, and by which variants are compared. */
public enum Outcome {
    /** Some sensor detects an attacking drone. */
    DETECTED(one -> true, one -> one.firstDetected().isPresent()),
    /** An alert is raised for an attacking drone. */
    ALERTED(one -> true, one -> one.alert().isPresent()),
    /** The alert leaves enough time for the response. */
    IN_TIME(one -> one.inTime().isPresent(), one -> one.inTime().orElse(false));

    private final Predicate<CaseResult> known;
    private final Predicate<CaseResult> met;

    Outcome(Predicate<CaseResult> known, Predicate<CaseResult> met) {
        this.known = known;
        this.met = met;
    }

    /** Whether the outcome is known for a case; false for a case that failed. */
    public boolean isKnown(CaseResult result) {
        return !result.isFailed() && known.test(result);
    }

    /** Whether a case has this outcome; false if it is not known. */
    public boolean isMetBy(CaseResult result) {
        return isKnown(result) && met.test(result);
    }
}
