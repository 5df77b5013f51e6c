package org.dronewatch.tracking;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.IntPredicate;

/**
 * Matches false contacts of different sensors as a tracker would: by time and bearing. Drones have one contact for all
 * sensors, which matches no other. Only contacts confirmed recently enough are remembered.
 */
final class BearingMatcher implements ContactMatcher {
    private final IntPredicate isDrone;
    private final double gate;
    private final double within;
    private final Map<Integer, MatchCandidate> recent = new HashMap<>();
    private final Map<String, SensorWindow> bySensor = new LinkedHashMap<>();
    private long confirmations;

    /**
     * A matcher without contacts.
     *
     * @param isDrone whether a contact, given by its number, is a drone
     * @param gate maximum difference of bearings, rad
     * @param within maximum difference of times, s
     */
    BearingMatcher(IntPredicate isDrone, double gate, double within) {
        this.isDrone = isDrone;
        this.gate = gate;
        this.within = within;
    }

    @Override
    public void confirm(ConfirmedContact confirmed) {
        if (!isDrone.test(confirmed.contact())) {
            remove(confirmed.contact());
            MatchCandidate now = new MatchCandidate(confirmed, confirmations++);
            recent.put(confirmed.contact(), now);
            bySensor.computeIfAbsent(confirmed.sensor(), unseen -> new SensorWindow())
                    .add(now);
        }
    }

    /** {@inheritDoc} If several contacts of one sensor are within the gate, the one nearest in bearing is returned. */
    @Override
    public List<ConfirmedContact> others(ConfirmedContact confirmed) {
        MatchCandidate own = recent.get(confirmed.contact());
        if (own == null) {
            return List.of();
        }
        List<MatchCandidate> others = new ArrayList<>();
        bySensor.forEach((sensor, window) -> {
            forgetBefore(confirmed.time() - within, window);
            if (!sensor.equals(confirmed.sensor())) {
                window.agreeing(own, gate).ifPresent(others::add);
            }
        });
        others.sort(MatchCandidate.BY_ORDER);
        return others.stream().map(MatchCandidate::confirmed).toList();
    }

    private void forgetBefore(double time, SensorWindow window) {
        for (Optional<MatchCandidate> old = window.before(time); old.isPresent(); old = window.before(time)) {
            remove(old.get().confirmed().contact());
        }
    }

    @Override
    public void remove(int contact) {
        MatchCandidate removed = recent.remove(contact);
        if (removed != null) {
            bySensor.get(removed.confirmed().sensor()).remove(removed);
        }
    }

    /** {@inheritDoc} These were confirmed recently enough to match others, at least when they were last compared. */
    @Override
    public int size() {
        return recent.size();
    }
}
