package org.dronewatch.flight.file;

/**
 * The speeds and the acceleration of a drone that apply where its flight file states none.
 *
 * @param cruise cruise speed, above 0, m/s
 * @param acceleration largest acceleration along the path, above 0, m/s2
 * @param climb largest rate of climb, above 0, m/s
 * @param sink largest rate of descent, above 0, m/s
 */
public record DroneSpeeds(double cruise, double acceleration, double climb, double sink) {}
