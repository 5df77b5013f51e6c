package org.dronewatch.sensor.acoustic.propagation;

import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Clearance;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The flat ground that reflects sound between two points: the plane that fits the surface under them best within the
 * first Fresnel zone about the point of reflection, where waves of one wavelength add up. The surface is what lies
 * straight below the line between the points and, within the zone, beside it. One per thread.
 */
public final class GroundPlane {
    /** Samples of the surface along the line and on each side of it. */
    private static final int ALONG = 7;

    private static final int ACROSS = 3;

    /** The zone follows from the point of reflection, and that from the plane in the zone: so many rounds. */
    private static final int ROUNDS = 2;

    /** Farther from the plane than so many standard deviations of the ground a point is not of the ground. */
    private static final double SPREAD = 3.0;

    private static final double TOLERANCE = 1e-3;

    private final TriangleMesh mesh;
    private final Visibility visibility;
    private final PlaneFit samples = new PlaneFit(ALONG * ACROSS);
    private final double[] normal = new double[3];

    /** The frame: u runs along the ground from the first point to below the second, v to the left, z up. */
    private Position from;

    private Position to;
    private double eastOfU;
    private double northOfU;
    private double distance;

    /** The plane {@code z = level + slopeU u + slopeV v}. */
    private double level;

    private double slopeU;
    private double slopeV;
    private double unevenness;

    private double heightOfFirst;
    private double heightOfSecond;
    private double reflectionU;
    private double reflectionV;
    private double firstU;
    private double lastU;
    private double halfWidth;
    private int material;

    /** In a world. */
    public GroundPlane(World world) {
        this.mesh = world.mesh();
        this.visibility = new Visibility(world);
    }

    /**
     * Looks for the ground between two points that see each other.
     *
     * @param first a point, m
     * @param second another one, m
     * @param wavelength of the sound, which determines the size of the zone, m, above 0
     * @return whether there is ground that reflects, seen from both points; the figures of this object are then those of it
     */
    public boolean find(Position first, Position second, double wavelength) {
        from = first;
        to = second;
        distance = Math.hypot(to.x() - from.x(), to.y() - from.y());
        boolean isBeside = distance > TOLERANCE;
        eastOfU = isBeside ? (to.x() - from.x()) / distance : 1.0;
        northOfU = isBeside ? (to.y() - from.y()) / distance : 0.0;
        if (!beginBelow()) {
            return false;
        }
        for (int round = 0; round < ROUNDS; round++) {
            setZone(wavelength);
            if (!fit() || !reflect()) {
                return false;
            }
        }
        return isSeen();
    }

    /** A first plane: level across, through the ground below the two points. */
    private boolean beginBelow() {
        double belowSecond = ground(distance, 0.0);
        if (Double.isNaN(belowSecond)) {
            return false;
        }
        double belowFirst = ground(0.0, 0.0);
        level = Double.isNaN(belowFirst) ? belowSecond : belowFirst;
        slopeU = distance > TOLERANCE ? (belowSecond - level) / distance : 0.0;
        slopeV = 0.0;
        return reflect();
    }

    private void setZone(double wavelength) {
        double before = lengthBefore();
        double after = lengthAfter();
        double cosine = (heightOfFirst + heightOfSecond) / (before + after);
        halfWidth = Math.sqrt(wavelength * before * after / (before + after));
        double halfLength = halfWidth / cosine;
        firstU = Math.max(reflectionU - halfLength, -halfWidth);
        lastU = Math.min(reflectionU + halfLength, distance + halfWidth);
    }

    /** Fits the plane to the surface in the zone; at least half of the samples must be on some surface. */
    private boolean fit() {
        samples.clear();
        for (int i = 0; i < ALONG; i++) {
            for (int j = 0; j < ACROSS; j++) {
                double u = firstU + (lastU - firstU) * i / (ALONG - 1);
                double v = halfWidth * (2.0 * j / (ACROSS - 1) - 1.0);
                double z = ground(u, v);
                if (!Double.isNaN(z)) {
                    samples.add(u, v, z);
                }
            }
        }
        if (2 * samples.count() < ALONG * ACROSS || !samples.fit()) {
            return false;
        }
        level = samples.level();
        slopeU = samples.slopeU();
        slopeV = samples.slopeV();
        unevenness = samples.standardDeviation();
        return true;
    }

    /** Computes heights above the plane and the point of reflection; gives whether both points are above the plane. */
    private boolean reflect() {
        heightOfFirst = above(0.0, 0.0, from.z());
        heightOfSecond = above(distance, 0.0, to.z());
        if (!(heightOfFirst > 0.0) || !(heightOfSecond > 0.0)) {
            return false;
        }
        // The feet of both points' perpendiculars, and the point between them.
        double scale = 1.0 / Math.sqrt(1.0 + slopeU * slopeU + slopeV * slopeV);
        double footU = slopeU * scale * heightOfFirst;
        double footV = slopeV * scale * heightOfFirst;
        double otherU = distance + slopeU * scale * heightOfSecond;
        double otherV = slopeV * scale * heightOfSecond;
        double fraction = heightOfFirst / (heightOfFirst + heightOfSecond);
        reflectionU = footU + fraction * (otherU - footU);
        reflectionV = footV + fraction * (otherV - footV);
        return true;
    }

    /** Bumps that are part of the unevenness hide nothing: waves pass over them. */
    private boolean isSeen() {
        double z = ground(reflectionU, reflectionV);
        if (Double.isNaN(z)) {
            return false;
        }
        material = mesh.material(visibility.triangle());
        Position at = new Position(
                x(reflectionU, reflectionV),
                y(reflectionU, reflectionV),
                Math.max(z, planeZ(reflectionU, reflectionV)) + SPREAD * unevenness + Clearance.GAP);
        return visibility.isFree(from, at) && visibility.isFree(to, at);
    }

    /**
     * The height of the surface at a point, m; not a number if there is none. It is looked for downward from the line
     * between the points; beside it, from as much higher as the point is away, which must be seen from the line.
     */
    private double ground(double u, double v) {
        double nearest = Math.max(0.0, Math.min(distance, u));
        double fraction = distance > TOLERANCE ? nearest / distance : 0.0;
        // Straight above each other the line stands on the ground: its lower end is what is nearest to it.
        double z = distance > TOLERANCE ? from.z() + fraction * (to.z() - from.z()) : Math.min(from.z(), to.z());
        double aside = Math.hypot(u - nearest, v);
        double x = x(u, v);
        double y = y(u, v);
        if (aside > 0.0 && !visibility.isFree(x(nearest, 0.0), y(nearest, 0.0), z, x, y, z + aside)) {
            return Double.NaN;
        }
        if (!visibility.findFirstAlong(x, y, z + aside, 0.0, 0.0, -1.0, Double.POSITIVE_INFINITY)) {
            return Double.NaN;
        }
        int triangle = visibility.triangle();
        mesh.normal(triangle, normal);
        return mesh.coordinate(triangle, 0, 2)
                - (normal[0] * (x - mesh.coordinate(triangle, 0, 0))
                                + normal[1] * (y - mesh.coordinate(triangle, 0, 1)))
                        / normal[2];
    }

    private double x(double u, double v) {
        return from.x() + eastOfU * u - northOfU * v;
    }

    private double y(double u, double v) {
        return from.y() + northOfU * u + eastOfU * v;
    }

    private double planeZ(double u, double v) {
        return level + slopeU * u + slopeV * v;
    }

    /** Signed distance of a point from the plane, m. */
    private double above(double u, double v, double z) {
        return (z - planeZ(u, v)) / Math.sqrt(1.0 + slopeU * slopeU + slopeV * slopeV);
    }

    private double lengthBefore() {
        return Math.hypot(Math.hypot(reflectionU, reflectionV), from.z() - planeZ(reflectionU, reflectionV));
    }

    private double lengthAfter() {
        return Math.hypot(Math.hypot(reflectionU - distance, reflectionV), to.z() - planeZ(reflectionU, reflectionV));
    }

    /** Whether a point is one of the ground in the zone, so that what it reflects is part of what the plane reflects. */
    public boolean covers(double x, double y, double z) {
        double east = x - from.x();
        double north = y - from.y();
        double u = eastOfU * east + northOfU * north;
        double v = eastOfU * north - northOfU * east;
        return u >= firstU - TOLERANCE
                && u <= lastU + TOLERANCE
                && Math.abs(v) <= halfWidth + TOLERANCE
                && Math.abs(above(u, v, z)) <= SPREAD * unevenness + TOLERANCE;
    }

    /** Distance of the first point from the plane, above 0, m. */
    public double heightOfFirst() {
        return heightOfFirst;
    }

    /** Distance of the second point from the plane, above 0, m. */
    public double heightOfSecond() {
        return heightOfSecond;
    }

    /** Length of the path over the reflection, m. */
    public double length() {
        return lengthBefore() + lengthAfter();
    }

    /** Sine of the elevation at which sound leaves the first point towards the reflection; negative downward. */
    public double rise() {
        return (planeZ(reflectionU, reflectionV) - from.z()) / lengthBefore();
    }

    /** Standard deviation of the ground's distance from the plane within the zone, m. */
    public double unevenness() {
        return unevenness;
    }

    /** The mesh's number of the material at the point of reflection. */
    public int material() {
        return material;
    }
}
