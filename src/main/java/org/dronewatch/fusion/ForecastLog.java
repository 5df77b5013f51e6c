package org.dronewatch.fusion;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.tracking.AssessedLook;

/**
 * A log of the alerts that {@link AlertRule.UnionOfProbabilities} forecasts for one run, for scoring: the probabilities
 * come from the simulation, which also knows the detection probabilities of looks that missed the contact. Nothing in a
 * run depends on these alerts.
 */
public final class ForecastLog {
    private static final double ROUNDING = 1e-12;

    private final AlertRule.UnionOfProbabilities rule;
    private final Map<Integer, Map<String, AssessedLook>> latest = new LinkedHashMap<>();
    private final Map<Integer, Alert> alerts = new LinkedHashMap<>();

    private ForecastLog(AlertRule.UnionOfProbabilities rule) {
        this.rule = rule;
    }

    /**
     * A log of a run at its start; empty unless the alert rule makes forecasts. {@link AlertLog} applies the other
     * rules.
     */
    public static Optional<ForecastLog> of(AlertSettings settings) {
        return settings.rule() instanceof AlertRule.UnionOfProbabilities union
                ? Optional.of(new ForecastLog(union))
                : Optional.empty();
    }

    /**
     * Adds the looks that the sensors took at one time.
     *
     * @return the alerts that are due at that time
     */
    public List<Alert> add(List<AssessedLook> looks) {
        for (AssessedLook look : looks) {
            if (!alerts.containsKey(look.contact())) {
                latest.computeIfAbsent(look.contact(), contact -> new LinkedHashMap<>())
                        .put(look.sensor(), look);
            }
        }
        List<Alert> due = new ArrayList<>();
        for (AssessedLook look : looks) {
            if (!alerts.containsKey(look.contact())) {
                List<String> sensors = carriers(latest.get(look.contact()).values(), look.time());
                if (!sensors.isEmpty()) {
                    Alert alert = new Alert(look.contact(), look.time(), sensors);
                    alerts.put(look.contact(), alert);
                    latest.remove(look.contact());
                    due.add(alert);
                }
            }
        }
        return due;
    }

    /** The sensors with the highest probabilities, as many as necessary; empty if all together do not suffice. */
    private List<String> carriers(Collection<AssessedLook> looks, double time) {
        List<AssessedLook> likeliest = new ArrayList<>(looks);
        likeliest.sort(Comparator.comparingDouble(look -> -probability(look, time)));
        double missed = 1.0;
        for (int i = 0; i < likeliest.size(); i++) {
            missed *= 1.0 - probability(likeliest.get(i), time);
            // Rounding must not make sensors less than certain together if each of them is certain.
            if (1.0 - missed >= rule.probability() - ROUNDING) {
                return likeliest.subList(0, i + 1).stream()
                        .map(AssessedLook::sensor)
                        .toList();
            }
        }
        return List.of();
    }

    private double probability(AssessedLook look, double time) {
        return look.time() >= time - rule.within() ? look.probability() : 0.0;
    }

    /** The alert for a contact, if there has been one. */
    public Optional<Alert> alert(int contact) {
        return Optional.ofNullable(alerts.get(contact));
    }

    /** Removes contacts, given by their numbers, that receive no more looks. */
    public void forget(Collection<Integer> ended) {
        ended.forEach(contact -> {
            latest.remove(contact);
            alerts.remove(contact);
        });
    }
}
