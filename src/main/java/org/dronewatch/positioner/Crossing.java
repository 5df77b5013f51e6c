package org.dronewatch.positioner;

import java.util.Optional;
import org.dronewatch.geometry.Position;

/**
 * The point at which the line of sight of one sensor passes that of another: a range from two directions
 * (triangulation).
 *
 * @param range range of the point from the first sensor, m
 * @param error standard error of the range, which follows from the errors of both directions and the angle between
 *     them, m
 */
record Crossing(double range, double error) {
    /** Smallest error assumed for a direction, rad: a drone is not a point, and it moves during a look. */
    private static final double LEAST_ERROR = 2e-3;

    /** Lines at an angle smaller than this, in standard errors, count as parallel. */
    private static final double DISTINCT = 4.0;

    /**
     * The greatest distance by which lines that count as meeting may miss each other, in standard errors; also in
     * metres.
     */
    private static final double MISS = 4.0;

    private static final double LEAST_MISS = 5.0;

    /**
     * The crossing of one line with another at a time. With the unit vectors u and v at the angle g to each other, and
     * the vector b from the first sensor to the second, the first line is nearest to the second at the range
     * {@code r = (b u - (u v) (b v)) / sin^2 g}, the second to the first at {@code s = ((u v) (b u) - b v) / sin^2 g};
     * the error of r is {@code sqrt((s dv)^2 + (r du cos g)^2) / sin g}, with the errors du and dv of the two
     * directions.
     *
     * @return empty for lines that are parallel to within their errors, miss each other, or would meet behind a sensor
     */
    static Optional<Crossing> of(Bearing one, Bearing other, double time) {
        Position u = one.at(time);
        Position v = other.at(time);
        Position base = other.from().minus(one.from());
        double firstError = Math.max(LEAST_ERROR, one.error());
        double secondError = Math.max(LEAST_ERROR, other.error());
        double cosine = u.dot(v);
        double sine = u.cross(v).length();
        if (!(sine > DISTINCT * Math.hypot(firstError, secondError))) {
            return Optional.empty();
        }
        double square = sine * sine;
        double range = (base.dot(u) - cosine * base.dot(v)) / square;
        double others = (cosine * base.dot(u) - base.dot(v)) / square;
        double miss = one.from().plus(u.times(range)).distance(other.from().plus(v.times(others)));
        double allowed = LEAST_MISS + MISS * Math.hypot(range * firstError, others * secondError);
        if (!(range > 0.0 && others > 0.0 && miss <= allowed)) {
            return Optional.empty();
        }
        return Optional.of(new Crossing(range, Math.hypot(others * secondError, range * firstError * cosine) / sine));
    }
}
