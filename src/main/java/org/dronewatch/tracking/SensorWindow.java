package org.dronewatch.tracking;

import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * One sensor's contacts that others may still match. Each query takes a time proportional to the logarithm of their
 * number.
 */
final class SensorWindow {
    private final TreeSet<MatchCandidate> byOrder = new TreeSet<>(MatchCandidate.BY_ORDER);
    private final TreeSet<MatchCandidate> byBearing = new TreeSet<>(MatchCandidate.BY_BEARING);

    void add(MatchCandidate contact) {
        byOrder.add(contact);
        byBearing.add(contact);
    }

    void remove(MatchCandidate contact) {
        byOrder.remove(contact);
        byBearing.remove(contact);
    }

    /** The contact that was confirmed earliest, if that was before a time, s. */
    Optional<MatchCandidate> before(double time) {
        return byOrder.isEmpty() || byOrder.first().confirmed().time() >= time
                ? Optional.empty()
                : Optional.of(byOrder.first());
    }

    /**
     * The contact nearest in bearing to another sensor's contact, if it lies within an angle, rad. Otherwise, the last
     * confirmed of the contacts without a bearing, which agree with any contact; for another contact without a bearing,
     * the last confirmed of all.
     */
    Optional<MatchCandidate> agreeing(MatchCandidate other, double angle) {
        if (byOrder.isEmpty()) {
            return Optional.empty();
        }
        if (!other.hasBearing()) {
            return Optional.of(byOrder.last());
        }
        MatchCandidate end = other.at(Double.NaN, Long.MIN_VALUE);
        MatchCandidate probe = other.at(other.confirmed().bearing(), Long.MAX_VALUE);
        // The first and the last contact by bearing are neighbours across south.
        Optional<MatchCandidate> nearest = Stream.of(
                        Optional.ofNullable(byBearing.floor(probe)),
                        Optional.ofNullable(byBearing.higher(probe)),
                        Optional.of(byBearing.first()),
                        Optional.ofNullable(byBearing.lower(end)))
                .flatMap(Optional::stream)
                .filter(one -> one.angleTo(other) <= angle)
                .min((a, b) -> Double.compare(a.angleTo(other), b.angleTo(other)));
        return nearest.or(() -> Optional.of(byBearing.last()).filter(one -> !one.hasBearing()));
    }
}
