package org.dronewatch.run;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeSet;
import org.dronewatch.fusion.Alert;
import org.dronewatch.fusion.AlertLog;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.Confirmation;
import org.dronewatch.fusion.FalseAlertRate;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.tracking.ContactLook;
import org.dronewatch.tracking.PerfectAssociation;

/** Applies other confirmations to the looks of a run, without any effect on it. */
final class ConfirmationTrials {
    private static final List<Confirmation> USUAL =
            List.of(new Confirmation(1, 1), new Confirmation(2, 3), new Confirmation(3, 5), new Confirmation(5, 8));

    private final PerfectAssociation association;
    private final Map<Confirmation, AlertLog> logs = new LinkedHashMap<>();

    /** Trials for a scene; none if its sensors state no rate of false alarms, or its rule confirms nothing. */
    ConfirmationTrials(SceneSettings settings, PerfectAssociation association) {
        this.association = association;
        for (Confirmation confirm : of(settings)) {
            AlertSettings changed = settings.alert().withConfirmation(confirm.hits(), confirm.looks());
            logs.put(confirm, new AlertLog(changed, association::matcher));
        }
    }

    /** The usual confirmations and the scene's own, the quickest first. */
    private static Set<Confirmation> of(SceneSettings settings) {
        Set<Confirmation> all = new TreeSet<>(Comparator.comparingInt(Confirmation::hits)
                .thenComparing(Confirmation::looks, Comparator.reverseOrder()));
        boolean isPriced = !FalseAlertRate.of(
                        settings.alert(),
                        settings.enabledSensors(),
                        settings.world().weather())
                .isUnknown();
        if (isPriced && !(settings.alert().rule() instanceof AlertRule.UnionOfProbabilities)) {
            all.addAll(USUAL);
            all.add(settings.alert().confirm());
        }
        return all;
    }

    /** Adds the sensors' looks of one time, except those at false contacts. */
    void add(List<ContactLook> looks) {
        if (!logs.isEmpty()) {
            List<ContactLook> atDrones = looks.stream()
                    .filter(look -> association.droneOf(look.contact()).isPresent())
                    .toList();
            logs.values().forEach(log -> log.add(atDrones));
        }
    }

    /** The results for drones of these names. */
    List<ConfirmationTrial> results(List<String> drones) {
        List<ConfirmationTrial> results = new ArrayList<>();
        logs.forEach((confirm, log) -> {
            Map<String, OptionalDouble> alerts = new LinkedHashMap<>();
            drones.forEach(drone -> alerts.put(drone, alert(drone, log)));
            results.add(new ConfirmationTrial(confirm, alerts));
        });
        return results;
    }

    private OptionalDouble alert(String drone, AlertLog log) {
        OptionalInt contact = association.contactOf(drone);
        return contact.isEmpty()
                ? OptionalDouble.empty()
                : log.alert(contact.getAsInt()).stream()
                        .mapToDouble(Alert::time)
                        .findFirst();
    }
}
