package org.dronewatch.fusion;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * The loose contacts that were confirmed recently enough for a rule for several sensors. Older ones can no longer agree
 * with any other contact.
 */
final class LooseContacts {
    private final AlertRule.SeveralSensors rule;
    private final Map<Integer, LooseContact> recent = new HashMap<>();
    private final Map<String, SensorWindow> bySensor = new LinkedHashMap<>();
    private long confirmations;

    LooseContacts(AlertRule.SeveralSensors rule) {
        this.rule = rule;
    }

    /** Records that a contact is confirmed at the present look of its sensor. */
    void confirmed(int contact, SensorTrack track, double time) {
        remove(contact);
        LooseContact now = new LooseContact(contact, track.sensor(), confirmations++, time, track.bearing());
        recent.put(contact, now);
        bySensor.computeIfAbsent(track.sensor(), unseen -> new SensorWindow()).add(now);
    }

    /**
     * Takes away a contact that is confirmed at the present look, and one of each other sensor that agrees with it: of
     * those within the gate the nearest in bearing.
     *
     * @return them, in the order of their confirmation; empty, and nothing is taken away, if they are too few for the
     *     rule, or the contact is not confirmed
     */
    List<LooseContact> takeTogether(int contact, double time) {
        LooseContact own = recent.get(contact);
        if (own == null || own.time() < time) {
            return List.of();
        }
        List<LooseContact> together = new ArrayList<>(List.of(own));
        bySensor.forEach((sensor, window) -> {
            forgetBefore(time - rule.within(), window);
            if (!sensor.equals(own.sensor())) {
                window.agreeing(own, rule.gate()).ifPresent(together::add);
            }
        });
        if (together.size() < rule.count()) {
            return List.of();
        }
        together.sort(LooseContact.BY_ORDER);
        together.forEach(one -> remove(one.contact()));
        return together;
    }

    private void forgetBefore(double time, SensorWindow window) {
        for (Optional<LooseContact> old = window.before(time); old.isPresent(); old = window.before(time)) {
            remove(old.get().contact());
        }
    }

    private void remove(int contact) {
        LooseContact removed = recent.remove(contact);
        if (removed != null) {
            bySensor.get(removed.sensor()).remove(removed);
        }
    }

    /** How many still count, or did when they were last compared. */
    int size() {
        return recent.size();
    }
}
