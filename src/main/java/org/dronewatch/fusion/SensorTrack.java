package org.dronewatch.fusion;

import org.dronewatch.sensor.Measurement;
import org.dronewatch.tracking.ContactLook;

/** The record of one sensor's looks at one contact so far. */
public final class SensorTrack {
    private final String sensor;
    private final ConfirmedLooks looks;
    private double confirmed = Double.NEGATIVE_INFINITY;
    private double looked = Double.NEGATIVE_INFINITY;
    private double probability;
    private double bearing = Double.NaN;

    SensorTrack(String sensor, Confirmation confirmation) {
        this.sensor = sensor;
        this.looks = new ConfirmedLooks(confirmation);
    }

    void add(ContactLook look) {
        looked = look.time();
        probability = look.probability();
        if (looks.add(look.isDetected())) {
            confirmed = looked;
        }
        for (Measurement measured : look.measurements()) {
            measured.sighting()
                    .ifPresent(seen ->
                            bearing = Math.IEEEremainder(seen.direction().azimuth(), 2.0 * Math.PI));
        }
    }

    /** Name of the sensor. */
    public String sensor() {
        return sensor;
    }

    /** Whether its detections were confirmed at its present look, or at one not longer ago than the given seconds. */
    boolean isConfirmedWithin(double seconds, double time) {
        return confirmed >= time - seconds;
    }

    /** The probability that its last look detected the drone, 0 if that look was longer ago than the given seconds. */
    double probabilityWithin(double seconds, double time) {
        return looked >= time - seconds ? probability : 0.0;
    }

    /** The bearing that it last measured, -pi to pi, rad; NaN if it has measured none. */
    double bearing() {
        return bearing;
    }
}
