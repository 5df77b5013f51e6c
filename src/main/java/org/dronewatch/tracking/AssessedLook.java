package org.dronewatch.tracking;

/**
 * The probability with which a look of a sensor would detect a contact, whether or not it did, for scoring: no sensor
 * knows this about a contact that it has not detected.
 *
 * @param contact number of the contact
 * @param sensor name of the sensor
 * @param time time of reception at the sensor, seconds since the start of the run
 * @param probability probability of detection, 0 to 1; for a sensor that does not estimate it, and for a false alarm, 1
 *     if the look detected the contact and 0 if it did not
 */
public record AssessedLook(int contact, String sensor, double time, double probability) {}
