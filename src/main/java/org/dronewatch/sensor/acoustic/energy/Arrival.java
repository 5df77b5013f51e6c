package org.dronewatch.sensor.acoustic.energy;

import java.util.Arrays;
import org.dronewatch.sensor.acoustic.imagesource.EnteredSolids;
import org.dronewatch.sensor.acoustic.imagesource.SpecularLeg;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;

/**
 * The path by which a ray from the start reached the surface that it hits: its legs between scatterings, which are
 * straight, lead via reflecting walls or pass through walls. For use by one thread.
 */
final class Arrival {
    private final SpecularLeg leg = new SpecularLeg();

    private final EnteredSolids solids = new EnteredSolids();

    private static final int LEGS = Connections.FROM_TARGET + 1;

    /** The inverse densities of the last legs, beginning with the one that ends here. */
    private final double[] inverseDensities = new double[LEGS];

    /** Whether each of these legs went through a wall. */
    private final boolean[] throughWalls = new boolean[LEGS];

    /** Whether rays from the target are not connected at these legs but may pass the start. */
    private final boolean[] isPassing = new boolean[LEGS];

    /** Whether rays from the target are not connected at these legs but may merge with this one where they end. */
    private final boolean[] isMerging = new boolean[LEGS];

    /** The number of surfaces that the ray had hit at the end of each of these legs, including the surface there. */
    private final int[] orders = new int[LEGS];

    private boolean isFromStart;
    private double leaving;
    private Ends ends;
    private ReceiverSphere receiver;

    /**
     * Begins a new ray.
     *
     * @param ofStart the sphere in which rays from the target that pass the start are counted
     */
    void start(Ends both, ReceiverSphere ofStart, AcousticRay ray) {
        ends = both;
        receiver = ofStart;
        isFromStart = true;
        solids.clear();
        Arrays.fill(inverseDensities, Connections.NEVER);
        Arrays.fill(throughWalls, false);
        leg.begin(ray);
    }

    /** Takes over the path of another ray of the same look. */
    void copy(Arrival other) {
        leg.copy(other.leg);
        solids.copy(other.solids);
        System.arraycopy(other.inverseDensities, 0, inverseDensities, 0, LEGS);
        System.arraycopy(other.throughWalls, 0, throughWalls, 0, LEGS);
        System.arraycopy(other.isPassing, 0, isPassing, 0, LEGS);
        System.arraycopy(other.isMerging, 0, isMerging, 0, LEGS);
        System.arraycopy(other.orders, 0, orders, 0, LEGS);
        isFromStart = other.isFromStart;
        leaving = other.leaving;
        ends = other.ends;
        receiver = other.receiver;
    }

    /**
     * Records that the ray was scattered at its origin.
     *
     * @param cosine cosine of the angle between the new direction and the surface's normal
     */
    void scatter(AcousticRay ray, double cosine) {
        isFromStart = false;
        leaving = cosine;
        for (int leg = inverseDensities.length - 1; leg > 0; leg--) {
            inverseDensities[leg] = inverseDensities[leg - 1];
            throughWalls[leg] = throughWalls[leg - 1];
            orders[leg] = orders[leg - 1];
            isPassing[leg] = isPassing[leg - 1];
            isMerging[leg] = isMerging[leg - 1];
        }
        leg.begin(ray);
    }

    /**
     * Records that the ray hit a surface.
     *
     * @param distance distance from its origin to the surface, m
     * @param arriving cosine of the angle between the ray and the surface's normal
     * @param order number of surfaces that it has hit, including this one
     */
    void meet(double distance, double arriving, int order) {
        leg.travel(distance);
        orders[0] = order;
        throughWalls[0] = leg.isThroughWalls();
        inverseDensities[0] = inverseDensity(arriving);
    }

    private double inverseDensity(double arriving) {
        boolean isOfImage = isFromStart ? leg.matchesFromStart(ends.ofStart()) : leg.matchesFromEnd(ends.ofTarget());
        boolean isUnknown = leg.order() > 0 && !isOfImage;
        isPassing[0] = isUnknown && isFromStart && ends.isOpen() && !leg.isThroughWalls();
        isMerging[0] = isUnknown && !isPassing[0] && !leg.isThroughWalls();
        if (isMerging[0]) {
            return receiver.inverseDensityOfMerging();
        }
        if (isUnknown) {
            return isPassing[0] ? receiver.inverseDensity(leg.length()) : Connections.NEVER;
        }
        double inAir = isFromStart
                ? Connections.fromPoint(arriving, leg.length())
                : Connections.betweenSurfaces(leaving, arriving, leg.length());
        return leg.isThroughWalls() ? Connections.throughWalls(inAir) : inAir;
    }

    /** Records that the ray was reflected specularly. */
    void reflect(int wall) {
        leg.reflect(wall);
    }

    /** Records that the ray passed through a wall. */
    void passThrough() {
        leg.passThrough();
    }

    /** The solids that the ray is inside. */
    EnteredSolids solids() {
        return solids;
    }

    /** The leg since the ray left the start or was scattered last. */
    SpecularLeg leg() {
        return leg;
    }

    /** Whether the ray has not been scattered yet. */
    boolean isFromStart() {
        return isFromStart;
    }

    /** Whether sound that would arrive straight from the target is computed exactly, or was already connected. */
    boolean isExact() {
        if (!isFromStart) {
            return leg.matchesFromEnd(ends.ofTarget());
        }
        // Exact paths pass through walls, too.
        return leg.order() == 1
                || leg.isReflectedFromStart(ends.pureOfStart())
                || leg.isReflectedFromEnd(ends.pureOfTarget())
                || leg.isReflectedFromEnd(ends.exactly());
    }

    /**
     * Whether this ray comes from a specular reflection that belongs to no known image source, so that it may merge.
     */
    boolean isMerging() {
        return isMerging[0];
    }

    /**
     * The sum of the inverse densities of those legs so far at which the same path could also be connected, if rays
     * from the target reached them.
     *
     * @param scatterings number of times that the rest of the path is scattered before it arrives here
     * @param surfaces number of surfaces that the rest of the path hits
     */
    double inverseDensity(int scatterings, int surfaces) {
        // Rays merge at the point at which a ray from the target is scattered first.
        boolean mayMerge = isMerging[0] && scatterings == 0 && surfaces < ScatteredSound.MOST;
        return (mayMerge ? inverseDensities[0] : 0.0) + sum(0, ends.scatterings() - scatterings, surfaces);
    }

    /**
     * The sum of the inverse densities of the legs before the ray was last scattered: if the ray passes the target
     * after specular reflections, rays from the target can be connected at these legs. 0 if those rays cannot reach
     * them.
     */
    double inverseDensityBefore() {
        return leg.isThroughWalls() ? Connections.NEVER : sum(1, LEGS, 0);
    }

    private double sum(int first, int end, int surfaces) {
        double sum = 0.0;
        for (int leg = first; leg < end; leg++) {
            if (surfaces + orders[0] - orders[leg] + 1 > ScatteredSound.MOST) {
                return sum;
            }
            // To pass the start, a ray from the target must go on from the last surface.
            boolean goesOn = leg < end - 1 && surfaces + orders[0] < ScatteredSound.MOST;
            if (!isMerging[leg] && (!isPassing[leg] || goesOn)) {
                sum += inverseDensities[leg];
            }
            if (throughWalls[leg]) {
                // Rays from the target end at walls.
                return sum;
            }
        }
        return sum;
    }
}
