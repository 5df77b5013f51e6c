package org.dronewatch.tracking;

/**
 * A contact at the moment at which a look of a sensor confirmed it.
 *
 * @param contact number of the contact
 * @param sensor name of the sensor
 * @param time time of that look, seconds since the start of the run
 * @param bearing the bearing that the sensor last measured, clockwise from north, -pi to pi, rad; NaN if it has
 *     measured none
 */
public record ConfirmedContact(int contact, String sensor, double time, double bearing) {
    boolean hasBearing() {
        return !Double.isNaN(bearing);
    }

    /** The angle between two bearings, 0 to pi, rad; NaN if one of them is not known. */
    double angleTo(ConfirmedContact other) {
        return Math.abs(Math.IEEEremainder(bearing - other.bearing, 2.0 * Math.PI));
    }
}
