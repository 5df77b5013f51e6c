package org.dronewatch.placement.site;

/**
 * The scene's own sensors, for comparison.
 *
 * @param sensors number of sensors
 * @param value what they achieve, in the unit of the objective
 */
public record PresentLayout(int sensors, double value) {}
