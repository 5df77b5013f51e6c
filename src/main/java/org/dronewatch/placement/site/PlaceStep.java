package org.dronewatch.placement.site;

/**
 * One step towards a layout: the sensor to be bought next.
 *
 * @param added its name
 * @param cost cost of all sensors so far
 * @param value their value, in the unit of the objective
 */
public record PlaceStep(String added, double cost, double value) {}
