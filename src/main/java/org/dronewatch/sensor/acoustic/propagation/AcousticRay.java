package org.dronewatch.sensor.acoustic.propagation;

/**
 * One straight piece of a sound ray. It carries two quantities: a level that decides and is not divided among branches,
 * and an energy that is. A reused carrier of numbers, for one thread.
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

    /** Share of the drone's emitted energy at the origin. */
    public double energy;

    /** Way from the drone to the origin, m. */
    public double travelled;

    /** How many surfaces it has met. */
    public int order;

    /** Number of the material that it runs through, or {@link #AIR}. */
    public int medium;
}
