package org.dronewatch.run;

import java.util.OptionalDouble;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.fusion.Protection;
import org.dronewatch.geometry.Position;

/**
 * When a flight reaches a protected zone, and how close it comes. The flight is approximated by straight segments of
 * equal duration, so that a crossing of the zone is found however fast the drone is. Where the path states a top speed,
 * segments that begin too far away to reach the zone are skipped, which does not change the result.
 */
public final class ZoneApproach {
    private static final int SEGMENTS = 10_000;

    /** More than the rounding errors of distances, m. */
    private static final double ROUNDING = 1e-6;

    private final FlightPath path;
    private final Protection zone;
    private final double step;

    /** The farthest that the drone flies in a segment, m; infinite if it is not known. */
    private final double reach;

    /**
     * The approach of a flight to protected zones.
     *
     * @param path the flight
     * @param zone the protected zones: not empty
     * @param simulated duration of the run, s
     */
    public ZoneApproach(FlightPath path, Protection zone, double simulated) {
        this.path = path;
        this.zone = zone;
        this.step = simulated / SEGMENTS;
        this.reach = path.topSpeed().orElse(Double.POSITIVE_INFINITY) * step;
    }

    /** The time at which the drone first reaches the zone, seconds since the start of the run; empty if it does not. */
    public OptionalDouble entered() {
        Position from = path.position(0.0);
        int segment = 0;
        while (segment < SEGMENTS) {
            int outside = Double.isInfinite(reach) ? 0 : within(zone.distance(from));
            if (outside > 0) {
                segment = Math.min(SEGMENTS, segment + outside);
                from = path.position(segment * step);
                continue;
            }
            Position to = path.position((segment + 1) * step);
            OptionalDouble share = zone.entry(from, to);
            if (share.isPresent()) {
                return OptionalDouble.of((segment + share.getAsDouble()) * step);
            }
            from = to;
            segment++;
        }
        return OptionalDouble.empty();
    }

    /** The smallest distance to the zone at the ends of the segments, m. */
    public double closest() {
        double closest = Double.POSITIVE_INFINITY;
        int moment = 0;
        while (moment <= SEGMENTS) {
            double distance = zone.distance(path.position(moment * step));
            closest = Math.min(closest, distance);
            moment += Math.max(1, within(distance - closest));
        }
        return closest;
    }

    /** Whether the drone is still coming closer to the zone when the run ends. */
    public boolean isCutShort() {
        double end = zone.distance(path.position(SEGMENTS * step));
        double before = zone.distance(path.position((SEGMENTS - 1) * step));
        return before - end > ROUNDING;
    }

    /** The number of whole segments in which the drone certainly flies less than a distance, m. */
    private int within(double distance) {
        double segments = (distance - ROUNDING) / reach;
        return segments >= 1.0 ? (int) Math.min(segments, SEGMENTS) : 0;
    }
}
