package org.dronewatch.fusion;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.tracking.ContactLook;

/** Follows the looks of one run at its contacts, in order of time, and records the first alert for each contact. */
public final class AlertLog {
    private final AlertSettings settings;
    private final Map<Integer, Map<String, SensorTrack>> tracks = new LinkedHashMap<>();
    private final Map<Integer, Alert> alerts = new LinkedHashMap<>();

    /** A log of a run at its start. */
    public AlertLog(AlertSettings settings) {
        this.settings = settings;
    }

    /** Adds the sensors' looks of one time. */
    public void add(List<ContactLook> looks) {
        for (ContactLook look : looks) {
            if (!alerts.containsKey(look.contact())) {
                tracks.computeIfAbsent(look.contact(), contact -> new LinkedHashMap<>())
                        .computeIfAbsent(look.sensor(), sensor -> new SensorTrack(sensor, settings.confirm()))
                        .add(look);
            }
        }
        for (ContactLook look : looks) {
            if (!alerts.containsKey(look.contact())) {
                decide(look.contact(), look.time());
            }
        }
    }

    private void decide(int contact, double time) {
        List<String> sensors = settings.rule().carriers(tracks.get(contact).values(), time).stream()
                .map(SensorTrack::sensor)
                .toList();
        if (!sensors.isEmpty()) {
            alerts.put(contact, new Alert(contact, time, sensors));
            tracks.remove(contact);
        }
    }

    /** The alert for a contact, if there has been one. */
    public Optional<Alert> alert(int contact) {
        return Optional.ofNullable(alerts.get(contact));
    }
}
