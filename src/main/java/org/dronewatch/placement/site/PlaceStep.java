package org.dronewatch.placement.site;

/**
 * One step towards a layout: the sensor to be bought next.
 *
 * @param added name of the sensor
 * @param cost cost of all sensors bought so far, including this one
 * @param value value of these sensors together with those that are kept, in the unit of the objective
 */
public record PlaceStep(String added, double cost, double value) {}
