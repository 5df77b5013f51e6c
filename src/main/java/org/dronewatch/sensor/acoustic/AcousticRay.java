package org.dronewatch.sensor.acoustic;

/**
 * One straight piece of a sound ray. It carries two quantities: a level that decides and is not divided among branches,
 * and an energy that is. A reused carrier of numbers, for one thread.
 */
final class AcousticRay {
    /** The medium of rays in the open. */
    static final int AIR = -1;

    double originX;
    double originY;
    double originZ;
    double directionX;
    double directionY;
    double directionZ;

    /** Undivided level at the origin, dB. */
    double level;

    /** Share of the drone's emitted energy at the origin. */
    double energy;

    /** Way from the drone to the origin, m. */
    double travelled;

    /** How many surfaces it has met. */
    int order;

    /** Number of the material that it runs through, or {@link #AIR}. */
    int medium;
}
