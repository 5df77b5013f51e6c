package org.dronewatch.fusion;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.tracking.ContactLook;

/**
 * A log of the alerts of one run: applies the alert rule to the looks at contacts, in order of time, and records the
 * first alert for each contact. A loose contact ({@link ContactLook#isLoose}) belongs to one sensor alone: a rule that
 * requires several sensors therefore combines loose contacts that agree in time and bearing.
 */
public final class AlertLog {
    private final AlertSettings settings;
    private final Map<Integer, Map<String, SensorTrack>> tracks = new LinkedHashMap<>();
    private final Map<Integer, Alert> alerts = new LinkedHashMap<>();
    private final Optional<LooseContacts> loose;

    /** A log of a run at its start. */
    public AlertLog(AlertSettings settings) {
        this.settings = settings;
        this.loose = settings.rule() instanceof AlertRule.SeveralSensors several
                ? Optional.of(new LooseContacts(several))
                : Optional.empty();
    }

    /**
     * Adds the looks that the sensors took at one time.
     *
     * @return the alerts that they raise. An alert for several loose contacts has the number of the latest of them
     */
    public List<Alert> add(List<ContactLook> looks) {
        for (ContactLook look : looks) {
            if (!alerts.containsKey(look.contact())) {
                follow(look);
            }
        }
        List<Alert> raised = new ArrayList<>();
        for (ContactLook look : looks) {
            if (!alerts.containsKey(look.contact())) {
                decide(look).ifPresent(raised::add);
            }
        }
        return raised;
    }

    private void follow(ContactLook look) {
        SensorTrack track = tracks.computeIfAbsent(look.contact(), contact -> new LinkedHashMap<>())
                .computeIfAbsent(look.sensor(), sensor -> new SensorTrack(sensor, settings.confirm()));
        track.add(look);
        if (loose.isPresent() && track.isConfirmedWithin(0.0, look.time()) && look.isLoose()) {
            loose.get().confirmed(look.contact(), track, look.time());
        }
    }

    private Optional<Alert> decide(ContactLook look) {
        int contact = look.contact();
        double time = look.time();
        if (loose.isPresent() && look.isLoose()) {
            List<LooseContact> together = loose.get().takeTogether(contact, time);
            return raise(
                    contact, time, together.stream().map(LooseContact::sensor).toList(), together);
        }
        List<SensorTrack> carriers =
                settings.rule().carriers(tracks.get(contact).values(), time);
        return raise(contact, time, carriers.stream().map(SensorTrack::sensor).toList(), List.of());
    }

    private Optional<Alert> raise(int contact, double time, List<String> sensors, List<LooseContact> others) {
        if (sensors.isEmpty()) {
            return Optional.empty();
        }
        Alert alert = new Alert(contact, time, sensors);
        alerts.put(contact, alert);
        tracks.remove(contact);
        for (LooseContact other : others) {
            // What has ended has been forgotten already, and will not be seen again.
            if (tracks.remove(other.contact()) != null) {
                alerts.put(other.contact(), alert);
            }
        }
        return Optional.of(alert);
    }

    /** The alert for a contact, if there has been one. */
    public Optional<Alert> alert(int contact) {
        return Optional.ofNullable(alerts.get(contact));
    }

    /** How many contacts it remembers at present. */
    int size() {
        return tracks.size() + alerts.size() + loose.map(LooseContacts::size).orElse(0);
    }

    /**
     * Removes contacts at which there will be no more looks. Until they are too old, their looks may still count
     * together with those at other contacts.
     */
    public void forget(Collection<Integer> ended) {
        ended.forEach(contact -> {
            tracks.remove(contact);
            alerts.remove(contact);
        });
    }
}
