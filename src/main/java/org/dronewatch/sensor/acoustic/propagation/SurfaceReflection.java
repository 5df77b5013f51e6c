package org.dronewatch.sensor.acoustic.propagation;

/**
 * Searches for the point of a fitted surface at which its tangent plane reflects sound between two points. If arcs of
 * sound are drawn as straight lines, the surface is bent in the opposite direction. For use by one thread.
 */
final class SurfaceReflection {
    /** Accuracy of the point, as a fraction of the length of the zone, and the maximum number of steps. */
    private static final double EXACT = 1e-9;

    private static final int STEPS = 60;

    private final SurfaceFit surface;
    private final MirrorPlane plane;
    private double bulge;
    private double distance;

    /**
     * A search.
     *
     * @param surface the surface
     * @param plane receives the tangent plane at the point
     */
    SurfaceReflection(SurfaceFit surface, MirrorPlane plane) {
        this.surface = surface;
        this.plane = plane;
    }

    /**
     * Searches from one point. On a plane, {@link #offset} leads to the point of reflection from anywhere; on a hill,
     * it overshoots, and in a hollow, or on flat ground if sound bends down, it falls short: there may then be several
     * points of reflection, of which the nearest one is found.
     *
     * @param from coordinate along the line at which the search begins, m
     * @param length length of the part of the surface that reflects, m, above 0
     * @param curvature curvature of the ground when arcs are drawn as straight lines, 1/m
     * @param ahead horizontal distance between the ends of the path, m
     * @return whether a point was found
     */
    boolean find(double from, double length, double curvature, double ahead) {
        bulge = curvature;
        distance = ahead;
        double exact = EXACT * length;
        double u = from;
        double of = offset(u);
        double step = Math.abs(of);
        for (int i = 0; i < STEPS && Math.abs(of) > exact; i++) {
            double next = u + Math.copySign(step, of);
            double ofNext = offset(next);
            if (of > 0.0 != ofNext > 0.0 && Math.abs(ofNext) > exact) {
                return findBetween(u, of, next, ofNext, exact);
            }
            u = next;
            of = ofNext;
            step = Math.max(length / STEPS, Math.abs(of));
        }
        return Math.abs(of) <= exact && plane.isBelowBoth();
    }

    /**
     * Searches between two points whose offsets lead towards each other, by regula falsi; the Illinois variant halves
     * the value at an end that stays the same.
     */
    private boolean findBetween(double one, double ofOne, double other, double ofOther, double exact) {
        double fixed = one;
        double ofFixed = ofOne;
        double latest = other;
        double ofLatest = ofOther;
        for (int i = 0; i < STEPS && Math.abs(ofLatest) > exact; i++) {
            double u = latest - (latest - fixed) * ofLatest / (ofLatest - ofFixed);
            double of = offset(u);
            if (of > 0.0 == ofLatest > 0.0) {
                ofFixed *= 0.5;
            } else {
                fixed = latest;
                ofFixed = ofLatest;
            }
            latest = u;
            ofLatest = of;
        }
        return plane.isBelowBoth();
    }

    /** Lays the plane that touches the surface at u and v = 0; returns the offset of its point of reflection. */
    private double offset(double u) {
        double bent = u > 0.0 && u < distance ? bulge * (0.5 * distance - u) : 0.0;
        double raised = PathCurvature.sag(bulge, distance, u);
        return plane.lay(u, surface.z(u, 0.0) + raised, surface.slopeU(u) + bent, surface.slopeV());
    }
}
