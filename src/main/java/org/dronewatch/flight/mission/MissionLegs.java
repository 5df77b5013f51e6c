package org.dronewatch.flight.mission;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.dronewatch.flight.GroundTrack;
import org.dronewatch.flight.TerrainProfile;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.GroundPoint;
import org.dronewatch.world.Places;

/**
 * Computes the legs of a mission from the points to which it leads. Between two points whose heights are measured from
 * the surface, the drone follows the surface as terrain-following flights do. For a single use.
 */
final class MissionLegs {
    /** Points nearer to each other than this count as the same, m. */
    private static final double SAME = 1e-3;

    /**
     * If the direction changes by less than this, the drone does not stop: a line at constant height above the sea
     * bends with the earth, by 1e-4 in a kilometre, and plans round positions to a centimetre.
     */
    private static final double STRAIGHT = 0.01;

    /** The greatest slope at which the drone climbs and descends as it follows the surface, m/m: 45 degrees. */
    private static final double STEEPEST = 1.0;

    private final double acceleration;
    private final double climbRate;
    private final double descentRate;
    private final Places places;
    private final List<Stop> stops = new ArrayList<>();

    /**
     * A point of the route.
     *
     * @param at position of the point, m
     * @param speed speed at which the drone flies there, m/s
     * @param above its height above the surface, if its height is measured from the surface, m
     * @param hold time for which the drone waits there, s
     */
    private record Stop(Position at, double speed, OptionalDouble above, double hold) {}

    MissionLegs(double acceleration, double climbRate, double descentRate, Places places) {
        this.acceleration = acceleration;
        this.climbRate = climbRate;
        this.descentRate = descentRate;
        this.places = places;
    }

    void begin(Position at) {
        stops.add(new Stop(at, Double.NaN, OptionalDouble.empty(), 0.0));
    }

    /** Flies on to a point; a point at the current position only changes the level from which heights are measured. */
    void to(Position at, double speed, OptionalDouble above) {
        Stop last = stops.get(stops.size() - 1);
        if (last.at.distance(at) <= SAME) {
            stops.set(stops.size() - 1, new Stop(last.at, last.speed, above, last.hold));
        } else {
            stops.add(new Stop(at, speed, above, 0.0));
        }
    }

    /** Waits at the last point, if there is one. */
    void hold(double seconds) {
        if (!stops.isEmpty()) {
            Stop last = stops.get(stops.size() - 1);
            stops.set(stops.size() - 1, new Stop(last.at, last.speed, last.above, last.hold + seconds));
        }
    }

    /** The path along all points. */
    MissionPath path(Position end) {
        List<MissionPath.Course> contours = contours();
        List<MissionPath.Leg> legs = new ArrayList<>();
        double heading = firstHeading();
        double time = stops.get(0).hold;
        int i = 1;
        while (i < stops.size()) {
            Stop to = stops.get(i);
            MissionPath.Course course = contours.get(i);
            int next = i + 1;
            if (course == null) {
                List<Position> line = new ArrayList<>(List.of(stops.get(i - 1).at, to.at));
                while (next < stops.size() && contours.get(next) == null && goesOn(next)) {
                    line.add(stops.get(next).at);
                    next++;
                }
                to = stops.get(next - 1);
                course = new MissionPath.Course(line.toArray(Position[]::new));
            }
            MissionPath.Leg leg = MissionPath.Leg.of(course, time, permitted(course, to.speed), acceleration, heading);
            legs.add(leg);
            heading = leg.heading();
            time = leg.end() + to.hold;
            i = next;
        }
        return new MissionPath(legs, end, heading);
    }

    /** Whether the drone flies through the previous stop without stopping. */
    private boolean goesOn(int next) {
        Stop before = stops.get(next - 2);
        Stop here = stops.get(next - 1);
        Stop to = stops.get(next);
        return here.hold == 0.0
                && here.speed == to.speed
                && here.at.minus(before.at).unit().distance(to.at.minus(here.at).unit()) <= STRAIGHT;
    }

    private double firstHeading() {
        for (int i = 1; i < stops.size(); i++) {
            Position leg = stops.get(i).at.minus(stops.get(i - 1).at);
            if (Math.hypot(leg.x(), leg.y()) > SAME) {
                return Math.atan2(leg.x(), leg.y());
            }
        }
        return 0.0;
    }

    /** The greatest speed up to the given one at which a course nowhere climbs or descends faster than allowed, m/s. */
    private double permitted(MissionPath.Course course, double speed) {
        double climb = course.steepest(1.0);
        double descent = course.steepest(-1.0);
        return Math.min(speed, Math.min(climbRate / Math.max(climb, 1e-12), descentRate / Math.max(descent, 1e-12)));
    }

    /**
     * For each stop, the course that leads to it along the surface; null for the other stops. Moves the stops onto
     * these courses.
     */
    private List<MissionPath.Course> contours() {
        List<MissionPath.Course> courses = new ArrayList<>();
        courses.add(null);
        int first = 0;
        for (int i = 1; i <= stops.size(); i++) {
            if (i == stops.size() || !follows(i)) {
                if (i - first > 1) {
                    follow(first, i, courses);
                }
                if (i < stops.size()) {
                    courses.add(null);
                }
                first = i;
            }
        }
        return courses;
    }

    private boolean follows(int stop) {
        Stop from = stops.get(stop - 1);
        Stop to = stops.get(stop);
        return from.above.isPresent()
                && to.above.isPresent()
                && Math.hypot(to.at.x() - from.at.x(), to.at.y() - from.at.y()) > SAME;
    }

    /** Flies from the first of some stops to the last, low over the surface. */
    private void follow(int first, int end, List<MissionPath.Course> courses) {
        List<GroundPoint> points = stops.subList(first, end).stream()
                .map(stop -> new GroundPoint(stop.at.x(), stop.at.y()))
                .toList();
        double length = 0.0;
        for (int i = 1; i < points.size(); i++) {
            length += points.get(i).distance(points.get(i - 1));
        }
        if (length > GroundTrack.LONGEST) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "a path of %.0f m with heights above the ground must be at most %.0f m long",
                    length,
                    GroundTrack.LONGEST));
        }
        GroundTrack track = new GroundTrack(points);
        double[] ground = TerrainProfile.over(track, places.ground(), STEEPEST);
        for (int i = 1; i < points.size(); i++) {
            int from = track.corner(i - 1);
            int to = track.corner(i);
            double before = stops.get(first + i - 1).above.getAsDouble();
            double after = stops.get(first + i).above.getAsDouble();
            Position[] places = new Position[to - from + 1];
            for (int node = from; node <= to; node++) {
                double share = (track.along(node) - track.along(from)) / (track.along(to) - track.along(from));
                places[node - from] =
                        new Position(track.x(node), track.y(node), ground[node] + before + share * (after - before));
            }
            courses.add(new MissionPath.Course(places));
            moveTo(first + i - 1, places[0]);
            moveTo(first + i, places[places.length - 1]);
        }
    }

    private void moveTo(int stop, Position at) {
        Stop known = stops.get(stop);
        stops.set(stop, new Stop(at, known.speed, known.above, known.hold));
    }
}
