package org.dronewatch.sensor.acoustic.propagation;

/**
 * The part of the ground that reflects: the first Fresnel zone around a point of reflection, as a rectangle in the
 * frame of {@link GroundProfile}. It ends a little beyond the ends of the path. For use by one thread.
 */
final class FresnelZone {
    private static final double TOLERANCE = 1e-3;

    private double firstU;
    private double lastU;
    private double middleV;
    private double halfWidth;

    /**
     * Lays the zone around the point at which a plane reflects.
     *
     * @param plane the plane
     * @param wavelength wavelength of the sound, m, above 0
     * @param distance horizontal distance between the ends of the path, m
     */
    void layAround(MirrorPlane plane, double wavelength, double distance) {
        double before = plane.lengthBefore();
        double after = plane.lengthAfter();
        double cosine = (plane.heightOfFirst() + plane.heightOfSecond()) / (before + after);
        halfWidth = Math.sqrt(wavelength * before * after / (before + after));
        double halfLength = halfWidth / cosine;
        double at = plane.reflectionU();
        firstU = Math.max(at - halfLength, Math.min(at, 0.0) - halfWidth);
        lastU = Math.min(at + halfLength, Math.max(at, distance) + halfWidth);
        middleV = plane.reflectionV();
    }

    /** Whether a point in plan view lies in the zone. */
    boolean contains(double u, double v) {
        return u >= firstU - TOLERANCE && u <= lastU + TOLERANCE && isWithinWidth(v);
    }

    /** Whether a point lies in the zone or before or beyond it, rather than to one side. */
    boolean isWithinWidth(double v) {
        return Math.abs(v - middleV) <= halfWidth + TOLERANCE;
    }

    /** Its beginning along the line, m. */
    double firstU() {
        return firstU;
    }

    /** Its end along the line, m. */
    double lastU() {
        return lastU;
    }

    /** The distance of its middle to the left of the line, m. */
    double middleV() {
        return middleV;
    }

    /** Half its width, across the line, m. */
    double halfWidth() {
        return halfWidth;
    }
}
