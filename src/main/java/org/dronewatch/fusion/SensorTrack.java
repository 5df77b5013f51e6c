package org.dronewatch.fusion;

import java.util.Optional;
import org.dronewatch.sensor.Measurement;
import org.dronewatch.tracking.ConfirmedContact;
import org.dronewatch.tracking.ContactLook;

/** The record of one sensor's looks at one contact so far. */
final class SensorTrack {
    private final ConfirmedLooks looks;
    private Optional<ConfirmedContact> confirmed = Optional.empty();
    private double bearing = Double.NaN;

    /** A record without looks. */
    SensorTrack(Confirmation confirmation) {
        this.looks = new ConfirmedLooks(confirmation);
    }

    /** Adds a look and returns whether it confirms the contact. */
    boolean add(ContactLook look) {
        for (Measurement measured : look.measurements()) {
            measured.sighting()
                    .ifPresent(seen ->
                            bearing = Math.IEEEremainder(seen.direction().azimuth(), 2.0 * Math.PI));
        }
        boolean isConfirmed = looks.add(look.isDetected());
        if (isConfirmed) {
            confirmed = Optional.of(new ConfirmedContact(look.contact(), look.sensor(), look.time(), bearing));
        }
        return isConfirmed;
    }

    /** The contact at the last look that confirmed it; empty if none has. */
    Optional<ConfirmedContact> confirmed() {
        return confirmed;
    }
}
