package org.dronewatch.placement.site;

/**
 * The scene's own sensors, for comparison.
 *
 * @param sensors number of sensors
 * @param value fraction of the airspace that they cover
 */
public record PresentLayout(int sensors, double value) {}
