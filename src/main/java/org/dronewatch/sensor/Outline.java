package org.dronewatch.sensor;

import org.dronewatch.geometry.Position;

/** The space that a sensor looks into, as a picture shows it: what stands in the way, and how far it reaches, is not in it. */
public sealed interface Outline {

    /**
     * What a camera's picture shows.
     *
     * @param forward unit vector of its axis
     * @param right unit vector to the right of the picture
     * @param up unit vector to the top of the picture
     * @param halfWidth half the width of what it sees at 1 m before it, m
     * @param halfHeight half the height of what it sees at 1 m before it, m
     */
    record Pyramid(Position forward, Position right, Position up, double halfWidth, double halfHeight)
            implements Outline {}

    /**
     * All within angles about a direction, and between two distances.
     *
     * @param azimuth of its middle, clockwise from north, rad
     * @param elevation of its middle, above the horizon, rad
     * @param azimuthWidth how wide it is, rad; 2 pi for all round
     * @param elevationWidth how high it is, rad
     * @param minRange where it begins, m
     * @param maxRange where it ends, m
     */
    record Sector(
            double azimuth,
            double elevation,
            double azimuthWidth,
            double elevationWidth,
            double minRange,
            double maxRange)
            implements Outline {}

    /**
     * All about it.
     *
     * @param radius m
     */
    record Ball(double radius) implements Outline {}
}
