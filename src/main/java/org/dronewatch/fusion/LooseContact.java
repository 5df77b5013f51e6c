package org.dronewatch.fusion;

import java.util.Comparator;

/**
 * A loose contact when a look of its sensor confirmed it.
 *
 * @param contact its number
 * @param sensor name of its sensor
 * @param order number of this confirmation among all of the run
 * @param time of that look, s
 * @param bearing last measured, -pi to pi, rad; NaN for a sensor that measures none
 */
record LooseContact(int contact, String sensor, long order, double time, double bearing) {
    /** The earliest confirmed first. */
    static final Comparator<LooseContact> BY_ORDER = Comparator.comparingLong(LooseContact::order);

    /** The order by bearing: contacts without one come last, and of equal ones the earliest confirmed comes first. */
    static final Comparator<LooseContact> BY_BEARING =
            Comparator.comparingDouble(LooseContact::bearing).thenComparing(BY_ORDER);

    boolean hasBearing() {
        return !Double.isNaN(bearing);
    }

    /** The angle between two bearings, 0 to pi, rad; NaN if one of them is not known. */
    double angleTo(LooseContact other) {
        return Math.abs(Math.IEEEremainder(bearing - other.bearing, 2.0 * Math.PI));
    }

    /** A contact that comes before all with this bearing, or after them, for searches. */
    LooseContact at(double azimuth, long place) {
        return new LooseContact(contact, sensor, place, time, azimuth);
    }
}
