package org.dronewatch.sensor.acoustic.propagation;

/**
 * One straight segment of a sound ray. It carries two quantities: a level, which is used for detection and copied to
 * every branch, and an energy, which is divided among branches. A mutable, reused object, for one thread.
 */
public final class AcousticRay {
    /** The medium of rays in the open. */
    public static final int AIR = -1;

    /** Where it begins, m. */
    public double originX;

    /** Where it begins, m. */
    public double originY;

    /** Where it begins, m. */
    public double originZ;

    /** Unit direction. */
    public double directionX;

    /** Unit direction. */
    public double directionY;

    /** Unit direction. */
    public double directionZ;

    /** Undivided level at the origin, dB. */
    public double level;

    /** Fraction of the drone's emitted energy at the origin. */
    public double energy;

    /** Path length from the drone to the origin, m. */
    public double travelled;

    /** Number of surfaces that it has hit. */
    public int order;

    /** Number of the material that it propagates in, or {@link #AIR}. */
    public int medium;
}
