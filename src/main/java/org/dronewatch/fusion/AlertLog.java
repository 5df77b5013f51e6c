package org.dronewatch.fusion;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.tracking.ConfirmedContact;
import org.dronewatch.tracking.ContactLook;
import org.dronewatch.tracking.ContactMatcher;

/**
 * A log of the alerts of one run: applies the alert rule to the looks at contacts, in order of time, and records the
 * first alert for each contact. It treats all contacts in the same way: which of them are one object is decided by the
 * association. A rule that forecasts alerts ({@link ForecastLog}) is not applied by this log, and raises no alerts in
 * it.
 */
public final class AlertLog {
    private final Confirmation confirm;
    private final Optional<AlertRule.Decision> rule;
    private final ContactMatcher matcher;
    private final Map<Integer, Map<String, SensorTrack>> tracks = new LinkedHashMap<>();
    private final Map<Integer, Alert> alerts = new LinkedHashMap<>();

    /**
     * A log of a run at its start.
     *
     * @param settings the rule and its confirmation
     * @param association decides which contacts of different sensors are one object
     */
    public AlertLog(AlertSettings settings, ContactMatcher.Source association) {
        this.confirm = settings.confirm();
        this.rule = settings.rule().decision();
        this.matcher = rule.map(decision -> decision.matcher(association)).orElse(ContactMatcher.NONE);
    }

    /**
     * Adds the looks that the sensors took at one time.
     *
     * @return the alerts that these looks raise; an alert based on several contacts has the number of the contact whose
     *     look completed it
     */
    public List<Alert> add(List<ContactLook> looks) {
        if (rule.isEmpty()) {
            return List.of();
        }
        for (ContactLook look : looks) {
            if (!alerts.containsKey(look.contact())) {
                follow(look);
            }
        }
        List<Alert> raised = new ArrayList<>();
        for (ContactLook look : looks) {
            if (!alerts.containsKey(look.contact())) {
                decide(look, rule.get()).ifPresent(raised::add);
            }
        }
        return raised;
    }

    private void follow(ContactLook look) {
        SensorTrack track = tracks.computeIfAbsent(look.contact(), contact -> new LinkedHashMap<>())
                .computeIfAbsent(look.sensor(), sensor -> new SensorTrack(confirm));
        if (track.add(look)) {
            track.confirmed().ifPresent(matcher::confirm);
        }
    }

    private Optional<Alert> decide(ContactLook look, AlertRule.Decision decision) {
        Map<String, SensorTrack> bySensor = tracks.get(look.contact());
        List<ConfirmedContact> together = new ArrayList<>();
        bySensor.get(look.sensor())
                .confirmed()
                .filter(own -> own.time() == look.time())
                .ifPresent(own -> together.addAll(matcher.others(own)));
        bySensor.values().forEach(track -> track.confirmed().ifPresent(together::add));
        List<ConfirmedContact> carriers = decision.carriers(together, look.time());
        return carriers.isEmpty() ? Optional.empty() : Optional.of(raise(look, carriers));
    }

    private Alert raise(ContactLook look, List<ConfirmedContact> carriers) {
        List<String> sensors = carriers.stream().map(ConfirmedContact::sensor).toList();
        Alert alert = new Alert(look.contact(), look.time(), sensors);
        end(look.contact(), alert);
        for (ConfirmedContact carrier : carriers) {
            // Contacts that have ended have already been forgotten, and will not be seen again.
            if (tracks.containsKey(carrier.contact())) {
                end(carrier.contact(), alert);
            }
            matcher.remove(carrier.contact());
        }
        return alert;
    }

    private void end(int contact, Alert alert) {
        alerts.put(contact, alert);
        tracks.remove(contact);
    }

    /** The alert for a contact, if there has been one. */
    public Optional<Alert> alert(int contact) {
        return Optional.ofNullable(alerts.get(contact));
    }

    /** The number of contacts that it remembers at present. */
    int size() {
        return tracks.size() + alerts.size() + matcher.size();
    }

    /**
     * Removes contacts, given by their numbers, that receive no more looks. Their confirmations still count, together
     * with those of other contacts, until they are too old for the rule.
     */
    public void forget(Collection<Integer> ended) {
        ended.forEach(contact -> {
            tracks.remove(contact);
            alerts.remove(contact);
        });
    }
}
