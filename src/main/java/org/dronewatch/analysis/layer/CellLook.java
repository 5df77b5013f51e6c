package org.dronewatch.analysis.layer;

import org.dronewatch.sensor.Assessment;

/**
 * The result of a sensor's looks at a drone in a cell.
 *
 * @param probability probability that the drone is detected on the terms of the field, 0 to 1
 * @param assessment the assessment whose cause represents all pointings of the sensor
 */
public record CellLook(double probability, Assessment assessment) {}
