package org.dronewatch.fusion;

import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Stream;

/**
 * One sensor's loose contacts that still count. Each query takes a time proportional to the logarithm of their number.
 */
final class SensorWindow {
    private final TreeSet<LooseContact> byOrder = new TreeSet<>(LooseContact.BY_ORDER);
    private final TreeSet<LooseContact> byBearing = new TreeSet<>(LooseContact.BY_BEARING);

    void add(LooseContact contact) {
        byOrder.add(contact);
        byBearing.add(contact);
    }

    void remove(LooseContact contact) {
        byOrder.remove(contact);
        byBearing.remove(contact);
    }

    /** The one confirmed earliest, if it was before a time, s. */
    Optional<LooseContact> before(double time) {
        return byOrder.isEmpty() || byOrder.first().time() >= time ? Optional.empty() : Optional.of(byOrder.first());
    }

    /**
     * The one nearest in bearing to another sensor's contact, if it lies within an angle, rad. Otherwise, and for a
     * contact without a bearing, the one confirmed last of those that agree with any.
     */
    Optional<LooseContact> agreeing(LooseContact other, double angle) {
        if (byOrder.isEmpty()) {
            return Optional.empty();
        }
        if (!other.hasBearing()) {
            return Optional.of(byOrder.last());
        }
        LooseContact end = other.at(Double.NaN, Long.MIN_VALUE);
        LooseContact probe = other.at(other.bearing(), Long.MAX_VALUE);
        // The first and the last one are neighbours across south.
        Optional<LooseContact> nearest = Stream.of(
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
