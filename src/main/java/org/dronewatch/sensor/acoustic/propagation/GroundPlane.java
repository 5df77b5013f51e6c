package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.Position;
import org.dronewatch.world.Clearance;
import org.dronewatch.world.World;

/**
 * The plane that represents the ground in the reflection of sound between two points. A plane or, if that fits better,
 * a surface that is convex along the path is fitted to the ground within the first Fresnel zone around the point of
 * reflection; the result is the tangent plane at the point of reflection. The ground consists of the surfaces straight
 * below the line between the points and, within the zone, beside it. For use by one thread.
 */
public final class GroundPlane {
    /** Number of samples of the surface along the line; also the numbers on each side of it. */
    private static final int ALONG = 7;

    private static final int ACROSS = 3;

    /**
     * Least and greatest number of iterations: the zone follows from the point of reflection, and this from the surface
     * in the zone. The first point may be far off, since it is searched for only straight below the line.
     */
    private static final int LEAST_ROUNDS = 2;

    private static final int MOST_ROUNDS = 6;

    /**
     * Number of parts into which the profile below the line is divided in the search for the first point of reflection.
     */
    private static final int PROFILE = 32;

    /** A point farther from the surface than this many standard deviations is not part of the ground. */
    private static final double SPREAD = 3.0;

    private static final double TOLERANCE = 1e-3;

    private final GroundProfile profile;
    private final SurfaceFit surface = new SurfaceFit(ALONG * ACROSS);
    private final MirrorPlane plane = new MirrorPlane();
    private final FresnelZone zone = new FresnelZone();
    private final SurfaceReflection reflection = new SurfaceReflection(surface, plane);
    private Position from;
    private Position to;
    private double distance;

    /** Curvature of the ground when arcs are drawn as straight lines, 1/m. */
    private double bulge;

    private double unevenness;

    private double firstOverGround;
    private double secondOverGround;
    /** Half the width of the zone in which ground beside the line belongs to the highest surface, m. */
    private double halfWidth;

    private int material;

    /** Ground planes in a world. */
    public GroundPlane(World world) {
        this.profile = new GroundProfile(world);
    }

    /**
     * Searches for the ground between two points that have a line of sight.
     *
     * @param first one point, m
     * @param second the other point, m
     * @param wavelength wavelength of the sound, which determines the size of the zone, m, above 0
     * @param curvature curvature of the sound path between the points, 1/m: arcs are treated as straight lines over
     *     ground that is curved in the opposite direction
     * @return whether there is reflecting ground, visible from both points; the properties of the plane can then be
     *     queried
     */
    public boolean find(Position first, Position second, double wavelength, double curvature) {
        from = first;
        to = second;
        measure(first, second);
        distance = profile.distance();
        plane.between(first.z(), second.z(), distance);
        // The sag is measured along the line, whereas u is the horizontal distance.
        double steepness = first.distance(second) / Math.max(distance, TOLERANCE);
        bulge = distance > TOLERANCE ? curvature * steepness * steepness : 0.0;
        if (!begin()) {
            return false;
        }
        for (int round = 1; round <= MOST_ROUNDS; round++) {
            zone.layAround(plane, wavelength, distance);
            if (!fit() || !reflection.find(plane.reflectionU(), zone.lastU() - zone.firstU(), bulge, distance)) {
                return false;
            }
            if (round >= LEAST_ROUNDS && zone.contains(plane.reflectionU(), plane.reflectionV())) {
                return isSeen();
            }
        }
        return false;
    }

    /**
     * Finds the highest surface at a position on the line between two points, in plan view. After that, only
     * {@link #material}, the heights of the points above the ground, and {@link #isBelow} can be queried.
     *
     * @param share position along the line as a fraction of its length in plan view, from the first point, 0 to 1
     * @param wavelength wavelength of the sound, which determines the width of the relevant ground beside the line, m,
     *     above 0
     * @return whether there is a surface
     */
    public boolean findHighest(Position first, Position second, double share, double wavelength) {
        measure(first, second);
        halfWidth = 0.5 * Math.sqrt(wavelength * profile.distance());
        boolean isThere = profile.findHighest(share * profile.distance());
        material = isThere ? profile.material() : material;
        return isThere;
    }

    private void measure(Position first, Position second) {
        profile.between(first, second);
        firstOverGround = first.z() - profile.z(0.0, 0.0);
        secondOverGround = second.z() - profile.z(profile.distance(), 0.0);
    }

    /** Height of the first point above the ground straight below it, m; NaN where there is none. */
    public double firstOverGround() {
        return firstOverGround;
    }

    /** Height of the second point above the ground straight below it, m; NaN where there is none. */
    public double secondOverGround() {
        return secondOverGround;
    }

    /**
     * Finds a first point of reflection, at which the path over the ground below the line is shortest (Fermat's
     * principle), and the plane in which it would be a reflection.
     */
    private boolean begin() {
        double shortest = Double.POSITIVE_INFINITY;
        double at = Double.NaN;
        double below = Double.NaN;
        for (int i = 0; i <= PROFILE; i++) {
            // The points are denser towards both ends, near which sound from far above is reflected.
            double u = distance * square(Math.sin(0.5 * Math.PI * i / PROFILE));
            double z = profile.z(u, 0.0) + raised(u);
            double length = Math.hypot(u, from.z() - z) + Math.hypot(distance - u, to.z() - z);
            if (length < shortest) {
                shortest = length;
                at = u;
                below = z;
            }
        }
        return shortest < Double.POSITIVE_INFINITY && plane.reflectAt(at, below);
    }

    private static double square(double value) {
        return value * value;
    }

    /** Fits a surface to the ground in the zone; at least half of the samples must lie on a surface. */
    private boolean fit() {
        surface.clear();
        double length = zone.lastU() - zone.firstU();
        for (int i = 0; i < ALONG; i++) {
            for (int j = 0; j < ACROSS; j++) {
                double u = zone.firstU() + length * i / (ALONG - 1);
                double v = zone.middleV() + zone.halfWidth() * (2.0 * j / (ACROSS - 1) - 1.0);
                double z = profile.z(u, v);
                if (!Double.isNaN(z)) {
                    surface.add(u, v, z);
                }
            }
        }
        return 2 * surface.count() >= ALONG * ACROSS
                && surface.fit(zone.firstU(), zone.lastU(), zone.middleV(), zone.halfWidth());
    }

    /**
     * Whether both points see the point of reflection. Bumps that are part of the unevenness hide nothing: waves pass
     * over them.
     */
    private boolean isSeen() {
        double u = plane.reflectionU();
        double v = plane.reflectionV();
        double z = profile.z(u, v);
        if (Double.isNaN(z)) {
            return false;
        }
        material = profile.material();
        unevenness = surface.standardDeviation();
        double mirror = plane.z(u, v) - raised(u);
        return profile.isSeen(u, v, Math.max(z, mirror) + SPREAD * unevenness + Clearance.GAP, bulge);
    }

    /** The height by which the ground is raised when arcs are drawn as straight lines, m. */
    private double raised(double u) {
        return PathCurvature.sag(bulge, distance, u);
    }

    /**
     * Whether a point belongs to the ground in the zone, so that the reflection at the point is part of the reflection
     * by the plane.
     */
    public boolean covers(double x, double y, double z) {
        double u = profile.u(x, y);
        double v = profile.v(x, y);
        // Straight paths meet bent ground elsewhere.
        boolean isAnywhere = bulge != 0.0 && u >= -TOLERANCE && u <= distance + TOLERANCE;
        return (isAnywhere ? zone.isWithinWidth(v) : zone.contains(u, v))
                && Math.abs(z - surface.z(u, v)) <= SPREAD * unevenness + TOLERANCE;
    }

    /**
     * Whether a point is part of the ground below the line between the points, or beside the line within the Fresnel
     * zone.
     */
    public boolean isBelow(double x, double y, double z) {
        double u = profile.u(x, y);
        double v = profile.v(x, y);
        return u >= -TOLERANCE
                && u <= profile.distance() + TOLERANCE
                && Math.abs(v) <= halfWidth
                && Math.abs(z - profile.z(u, v)) <= TOLERANCE;
    }

    /** Distance of the first point from the plane, above 0, m. */
    public double heightOfFirst() {
        return plane.heightOfFirst();
    }

    /** Distance of the second point from the plane, above 0, m. */
    public double heightOfSecond() {
        return plane.heightOfSecond();
    }

    /** Length of the path via the reflection point, m. */
    public double length() {
        return plane.lengthBefore() + plane.lengthAfter();
    }

    /** Sine of the elevation at which sound leaves the first point towards the reflection; negative downward. */
    public double rise() {
        return plane.rise();
    }

    /** Standard deviation of the ground's distance from the fitted surface within the zone, m. */
    public double unevenness() {
        return unevenness;
    }

    /** The index, in the mesh, of the material at the point of reflection. */
    public int material() {
        return material;
    }
}
