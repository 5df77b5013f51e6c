package org.dronewatch.flight;

import java.util.Arrays;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/** A path over a ground track, flown at constant speed through space; the drone stays at its end. */
final class TerrainPath implements FlightPath {
    private static final Position REST = new Position(0, 0, 0);

    private final Position[] points;
    private final double[] flown;
    private final double speed;

    /**
     * A path over a profile.
     *
     * @param profile height of the surface below each node of the track, m
     * @param height height of the drone above the profile, m
     * @param speed speed along the path, m/s
     */
    TerrainPath(GroundTrack track, double[] profile, double height, double speed) {
        this.points = new Position[profile.length];
        this.flown = new double[profile.length];
        this.speed = speed;
        for (int i = 0; i < profile.length; i++) {
            points[i] = new Position(track.x(i), track.y(i), profile[i] + height);
            flown[i] = i == 0 ? 0.0 : flown[i - 1] + points[i].distance(points[i - 1]);
        }
    }

    @Override
    public FlightState at(double time) {
        double travelled = speed * time;
        int last = points.length - 1;
        if (travelled >= flown[last]) {
            return new FlightState(points[last], REST, heading(last));
        }
        int found = Arrays.binarySearch(flown, travelled);
        // For a distance between two nodes, the search returns -(insertion point) - 1.
        int next = found >= 0 ? found + 1 : -found - 1;
        Position from = points[next - 1];
        Position leg = points[next].minus(from);
        double length = flown[next] - flown[next - 1];
        Position direction = leg.times(1.0 / length);
        return new FlightState(
                from.plus(direction.times(travelled - flown[next - 1])), direction.times(speed), heading(next));
    }

    @Override
    public OptionalDouble topSpeed() {
        return OptionalDouble.of(speed);
    }

    /** The heading along the segment of the track that ends at a node, rad. */
    private double heading(int node) {
        Position leg = points[node].minus(points[node - 1]);
        return Math.atan2(leg.x(), leg.y());
    }
}
