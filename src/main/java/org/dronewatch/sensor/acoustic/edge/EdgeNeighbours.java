package org.dronewatch.sensor.acoustic.edge;

import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * Finds the surfaces that touch an edge without sharing its corners: the ground on which a wall stands, or the other
 * half of a wall that is divided differently. For use by one thread.
 */
final class EdgeNeighbours {
    /** Surfaces are looked for on a circle of this radius about a point of the edge, m. */
    private static final double RADIUS = 5e-3;

    /** The circle is followed by this many chords, each of which begins a little before the last one has ended. */
    private static final int CHORDS = 8;

    /** Angle between the surfaces of the edge itself and the first and last chord, rad. */
    private static final double BESIDE = 1e-2;

    private static final double OVERLAP = 1e-2;

    private final Visibility visibility;
    private final TriangleMesh mesh;
    private final double[] hit = new double[2];
    private final double[] normal = new double[3];

    EdgeNeighbours(World world) {
        this.mesh = world.mesh();
        this.visibility = Visibility.ofClearPoints(world);
    }

    /**
     * Widens the cone of the surfaces of an edge to the others that touch the edge.
     *
     * @param cone of a corner, in the plane of the two axes
     * @param at a point of the edge, m
     * @param ahead the first axis, of length 1
     * @param side the second axis, perpendicular to the first
     * @param triangle one of the edge's own
     * @return the least angle between its plane and that of another surface, rad; pi if nothing else touches the edge
     */
    double widen(Cone cone, Position at, Position ahead, Position side, int triangle) {
        double fold = Math.PI;
        double from = Math.atan2(cone.lastV(), cone.lastU()) + BESIDE;
        double to = Math.atan2(cone.firstV(), cone.firstU()) - BESIDE;
        double turn = to - from;
        double whole = turn > 0.0 ? turn : turn + 2.0 * Math.PI;
        for (int chord = 0; chord < CHORDS; chord++) {
            double start = from + whole * chord / CHORDS - (chord > 0 ? OVERLAP : 0.0);
            double end = from + whole * (chord + 1) / CHORDS;
            if (meets(at, ahead, side, start, end)) {
                double length = Math.hypot(hit[0], hit[1]);
                cone.add(hit[0] / length, hit[1] / length);
                fold = Math.min(fold, angle(triangle, visibility.triangle()));
            }
        }
        return fold;
    }

    private double angle(int triangle, int other) {
        mesh.normal(triangle, normal);
        Position one = new Position(normal[0], normal[1], normal[2]);
        mesh.normal(other, normal);
        double angle = one.angle(new Position(normal[0], normal[1], normal[2]));
        return Math.min(angle, Math.PI - angle);
    }

    private boolean meets(Position at, Position ahead, Position side, double start, double end) {
        double u = RADIUS * Math.cos(start);
        double v = RADIUS * Math.sin(start);
        double du = RADIUS * Math.cos(end) - u;
        double dv = RADIUS * Math.sin(end) - v;
        Position first = at.plus(ahead.times(u)).plus(side.times(v));
        Position along = ahead.times(du).plus(side.times(dv));
        boolean isMet =
                visibility.findFirstAlong(first.x(), first.y(), first.z(), along.x(), along.y(), along.z(), 1.0);
        if (isMet) {
            hit[0] = u + visibility.distance() * du;
            hit[1] = v + visibility.distance() * dv;
        }
        return isMet;
    }
}
