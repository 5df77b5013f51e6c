package org.dronewatch.route;

/** At which point of a task the intruder is detected, if it is detected during that task. */
public enum Sensing {
    /** As the task begins. */
    BEGIN(1.0),
    /** Halfway through. */
    MIDDLE(0.5),
    /** As it ends. */
    END(0.0);

    private final double left;

    Sensing(double left) {
        this.left = left;
    }

    /** The fraction of the task that is still to come, 0 to 1. */
    public double left() {
        return left;
    }
}
