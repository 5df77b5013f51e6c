package org.dronewatch.tracking;

import java.util.Comparator;

/**
 * A confirmed contact that another one may match.
 *
 * @param confirmed the contact
 * @param order number of this confirmation among all of the run
 */
record MatchCandidate(ConfirmedContact confirmed, long order) {
    /** The earliest confirmed first. */
    static final Comparator<MatchCandidate> BY_ORDER = Comparator.comparingLong(MatchCandidate::order);

    /** The order by bearing: contacts without one come last, and of equal ones the earliest confirmed comes first. */
    static final Comparator<MatchCandidate> BY_BEARING =
            Comparator.comparingDouble(MatchCandidate::bearing).thenComparing(BY_ORDER);

    private double bearing() {
        return confirmed.bearing();
    }

    boolean hasBearing() {
        return confirmed.hasBearing();
    }

    double angleTo(MatchCandidate other) {
        return confirmed.angleTo(other.confirmed);
    }

    /** A candidate that comes before all with this bearing, or after them, for searches. */
    MatchCandidate at(double bearing, long place) {
        return new MatchCandidate(
                new ConfirmedContact(confirmed.contact(), confirmed.sensor(), confirmed.time(), bearing), place);
    }
}
