package org.dronewatch.fusion;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * The conditions of an alert, the protected zones, and the time that the response takes.
 *
 * @param rule rule that determines when the sensors' looks raise an alert
 * @param confirm confirmation required of a sensor: the number of its most recent looks that must detect the drone
 * @param protect the sphere that drones must not reach; omit it if there is none
 * @param zones further areas that drones must not reach, by name; the first that a drone enters counts
 * @param response time required between the alert and the drone's arrival, 0 to 86400 s; 0 if none is required
 */
public record AlertSettings(
        AlertRule rule,
        Confirmation confirm,
        Optional<ProtectedZone> protect,
        Map<String, ProtectedArea> zones,
        @In(value = Quantity.DURATION, from = 0, to = 86_400) double response) {
    /** The first detection by any sensor is an alert; nothing is protected. */
    @Defaults
    public static final AlertSettings DEFAULT =
            new AlertSettings(new AlertRule.AnySensor(), Confirmation.DEFAULT, Optional.empty(), Map.of(), 0.0);

    /** Checks the limits. */
    public AlertSettings {
        Limits.check(AlertSettings.class, rule, confirm, protect, zones, response);
        zones = Collections.unmodifiableMap(new LinkedHashMap<>(zones));
        zones.forEach((name, area) -> area.checkOutline("zones." + name));
        if (rule instanceof AlertRule.UnionOfProbabilities && !confirm.equals(Confirmation.DEFAULT)) {
            throw new IllegalArgumentException(
                    "confirm " + confirm.hits() + " of " + confirm.looks()
                            + " looks has no meaning with union-of-probabilities, which combines probabilities, not detections");
        }
    }

    /** These settings with another rule. */
    public AlertSettings withRule(AlertRule other) {
        return SettingsForm.with(this, "rule", other);
    }

    /** These settings with another confirmation: {@code hits} detections in a sensor's last {@code looks} looks. */
    public AlertSettings withConfirmation(int hits, int looks) {
        return SettingsForm.with(this, "confirm", new Confirmation(hits, looks));
    }

    /** Whether there are protected zones. */
    public boolean isProtecting() {
        return protect.isPresent() || !zones.isEmpty();
    }

    /** These settings with a further protected area, which replaces any area of the same name. */
    public AlertSettings withZone(String name, ProtectedArea area) {
        Map<String, ProtectedArea> more = new LinkedHashMap<>(zones);
        more.put(name, area);
        return SettingsForm.with(this, "zones", more);
    }

    /** These settings with a protected zone and the time that the response to an alert takes, s. */
    public AlertSettings withProtectedZone(ProtectedZone zone, double seconds) {
        return SettingsForm.with(this, Map.of("protect", Optional.of(zone), "response", seconds));
    }
}
