package org.dronewatch.world;

/**
 * The aspects of the weather and light of a site on which the number of a sensor's false alarms may depend.
 *
 * @param rain rain rate, mm/h
 * @param wind wind speed at a height of 10 m, m/s
 * @param visibility visibility, m
 * @param illuminance illuminance of the ground, lx
 */
public record Weather(double rain, double wind, double visibility, double illuminance) {}
