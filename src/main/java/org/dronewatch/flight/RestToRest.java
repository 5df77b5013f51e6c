package org.dronewatch.flight;

/**
 * A motion over a distance from rest to rest: constant acceleration, cruise, constant deceleration. Over a short
 * distance, the greatest speed is not reached.
 */
public final class RestToRest {
    private final double length;
    private final double acceleration;
    private final double topSpeed;
    private final double rampTime;
    private final double duration;

    /**
     * A motion.
     *
     * @param length distance from start to end, above 0, m
     * @param speed the greatest speed, above 0, m/s
     * @param acceleration acceleration and deceleration, above 0, m/s2
     */
    public RestToRest(double length, double speed, double acceleration) {
        this.length = length;
        this.acceleration = acceleration;
        // v^2 = a * length in the middle of a short leg.
        this.topSpeed = Math.min(speed, Math.sqrt(acceleration * length));
        this.rampTime = topSpeed / acceleration;
        this.duration = length / topSpeed + rampTime;
    }

    /** The duration of the motion, s. */
    public double duration() {
        return duration;
    }

    /** The distance covered, m, at a time since the start of the motion, 0 or more, s. */
    public double distance(double time) {
        double left = duration - time;
        if (left <= 0.0) {
            return length;
        }
        if (time < rampTime) {
            return 0.5 * acceleration * time * time;
        }
        return left < rampTime ? length - 0.5 * acceleration * left * left : topSpeed * (time - 0.5 * rampTime);
    }

    /** The speed, m/s, at a time since the start of the motion, 0 or more, s. */
    public double speed(double time) {
        double left = duration - time;
        if (left <= 0.0) {
            return 0.0;
        }
        if (time < rampTime) {
            return acceleration * time;
        }
        return left < rampTime ? acceleration * left : topSpeed;
    }
}
