package org.dronewatch.tracking;

import java.util.Comparator;

/**
 * A confirmed contact that another one may match.
 *
 * @param confirmed the contact
 * @param order number of this confirmation among all confirmations of the run
 */
record MatchCandidate(ConfirmedContact confirmed, long order) {
    /** The order of confirmation, the earliest first. */
    static final Comparator<MatchCandidate> BY_ORDER = Comparator.comparingLong(MatchCandidate::order);

    /**
     * The order by bearing: contacts without a bearing come last; of contacts with equal bearings, the one confirmed
     * earliest comes first.
     */
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

    /** A candidate for searches, which comes before or after all candidates with a given bearing. */
    MatchCandidate at(double bearing, long place) {
        return new MatchCandidate(
                new ConfirmedContact(confirmed.contact(), confirmed.sensor(), confirmed.time(), bearing), place);
    }
}
