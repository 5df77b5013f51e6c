package org.dronewatch.placement.site;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.fusion.AlertRule;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.SiteCandidate;
import org.dronewatch.scenario.PriceSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.DirectionFinding;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.SettingsForm;

/** Makes scenes in which the sensors are replaced by those of a layout. */
public final class Layout {
    private Layout() {}

    /**
     * A scene with some sensors. All others of the scene are switched off rather than removed, so that those to which
     * a sensor refers still exist.
     *
     * @param sensors the sensors that are enabled, by name
     */
    public static SceneSettings alone(SceneSettings scene, Map<String, SensorSettings<?>> sensors) {
        Map<String, SensorSettings<?>> all = new LinkedHashMap<>(scene.sensors());
        all.putAll(sensors);
        Set<String> others = new LinkedHashSet<>(all.keySet());
        others.removeAll(sensors.keySet());
        return SettingsForm.with(scene, Map.of("sensors", all, "disabled", others));
    }

    /**
     * The scene of a plan with only the sensors of a layout enabled, so that it is consistent even if sensors of the
     * scene refer to others.
     */
    public static SceneSettings alone(PlacePlan plan, List<SiteCandidate> chosen) {
        return alone(plan.present(), sensors(chosen));
    }

    /** The sensors of a layout by their names. */
    static Map<String, SensorSettings<?>> sensors(List<SiteCandidate> chosen) {
        Map<String, SensorSettings<?>> sensors = new LinkedHashMap<>();
        chosen.forEach(one -> sensors.put(one.name(), one.sensor()));
        return sensors;
    }

    /**
     * The scene of a plan with only some of its candidates, and their prices.
     *
     * @throws InputException when the scene needs a sensor that is missing
     */
    public static SceneSettings of(PlacePlan plan, List<SiteCandidate> chosen) {
        SceneSettings present = plan.present();
        Map<String, SensorSettings<?>> sensors = new LinkedHashMap<>();
        Map<String, Double> prices = new LinkedHashMap<>();
        chosen.forEach(one -> {
            sensors.put(one.name(), one.sensor());
            Double known = present.prices().sensors().get(one.name());
            boolean isKept = one.candidate().fixed();
            if (!isKept || known != null) {
                prices.put(one.name(), isKept ? known : one.candidate().cost());
            }
        });
        if (present.alert().rule() instanceof AlertRule.SeveralSensors rule && rule.count() > sensors.size()) {
            throw new InputException("alert.rule.count " + rule.count() + ": the layout has only "
                    + Counted.of(sensors.size(), "sensor"));
        }
        try {
            return SettingsForm.with(
                    present,
                    Map.of(
                            "sensors",
                            cued(sensors, present.sensors().keySet()),
                            "disabled",
                            Set.of(),
                            "prices",
                            new PriceSettings(present.prices().currency(), prices)));
        } catch (IllegalArgumentException e) {
            throw new InputException(e.getMessage(), e);
        }
    }

    /** The sensors, with cues added for positioners that name none: from all other sensors that measure directions. */
    private static Map<String, SensorSettings<?>> cued(Map<String, SensorSettings<?>> sensors, Set<String> kept) {
        Map<String, SensorSettings<?>> all = new LinkedHashMap<>(sensors);
        all.replaceAll((name, sensor) -> {
            List<String> cues = sensors.keySet().stream()
                    .filter(other -> !other.equals(name))
                    .filter(other ->
                            sensors.get(other).as(DirectionFinding.class).isPresent())
                    .toList();
            return Mounted.positioner(sensor)
                    .filter(its -> its.cues().isEmpty() && !kept.contains(name))
                    .<SensorSettings<?>>map(its -> (SensorSettings<?>) SettingsForm.with(
                            (Record) sensor, "positioner", Optional.of(its.withCues(cues.toArray(String[]::new)))))
                    .orElse(sensor);
        });
        return all;
    }
}
