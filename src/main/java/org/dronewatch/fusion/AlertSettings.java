package org.dronewatch.fusion;

import java.util.Map;
import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/**
 * When an alert is raised, what has to be protected, and how much time the response needs.
 *
 * @param rule when the sensors' observations amount to an alert
 * @param confirm how often a sensor must detect a drone before it counts
 * @param protect the zone that must not be reached; omit it for none
 * @param response how much time is needed between the alert and the drone's arrival, 0 to 86400 s; 0 if not required
 */
public record AlertSettings(
        AlertRule rule,
        Confirmation confirm,
        Optional<ProtectedZone> protect,
        @In(value = Quantity.DURATION, from = 0, to = 86_400) double response) {
    /** The first detection of any sensor is an alert; nothing is protected. */
    @Defaults
    public static final AlertSettings DEFAULT =
            new AlertSettings(new AlertRule.AnySensor(), Confirmation.DEFAULT, Optional.empty(), 0.0);

    /** Checks the limits. */
    public AlertSettings {
        Limits.check(AlertSettings.class, rule, confirm, protect, response);
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

    /** These settings with a number of detections required out of a number of looks of a sensor. */
    public AlertSettings withConfirmation(int hits, int looks) {
        return SettingsForm.with(this, "confirm", new Confirmation(hits, looks));
    }

    /** These settings with a protected zone and the time that the response to an alert takes, s. */
    public AlertSettings withProtectedZone(ProtectedZone zone, double seconds) {
        return SettingsForm.with(this, Map.of("protect", Optional.of(zone), "response", seconds));
    }
}
