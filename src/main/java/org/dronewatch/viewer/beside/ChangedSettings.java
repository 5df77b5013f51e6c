package org.dronewatch.viewer.beside;

import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.viewer.settings.SettingRow;

/** How the settings of the sensors in one run differ from those in another, in words. */
final class ChangedSettings {
    /** Of further changes, only the number is given. */
    private static final int MOST = 5;

    private static final MathContext DIGITS = new MathContext(4);
    private static final Pattern LONG = Pattern.compile("\\d+\\.\\d{3,}(?![\\dEe])");

    private ChangedSettings() {}

    /** A sentence, such as {@code Sensors that differ: 'roof' fov 12 deg (other run: 60 deg).} */
    static String text(SceneSettings here, SceneSettings there) {
        List<String> changes = new ArrayList<>();
        Set<String> sensors = new LinkedHashSet<>(here.sensors().keySet());
        sensors.addAll(there.sensors().keySet());
        for (String id : sensors) {
            SensorSettings<?> mine = here.sensors().get(id);
            SensorSettings<?> other = there.sensors().get(id);
            if (mine == null || other == null) {
                changes.add("'" + id + "' only in " + (other == null ? "this run" : "the other run"));
                continue;
            }
            boolean isOn = here.enabledSensors().containsKey(id);
            if (isOn != there.enabledSensors().containsKey(id)) {
                changes.add("'" + id + "' " + (isOn ? "on" : "off") + " (other run: " + (isOn ? "off" : "on") + ")");
            }
            if (!mine.equals(other)) {
                addChanges(id, mine, other, changes);
            }
        }
        if (changes.isEmpty()) {
            return "All sensors have the same settings as in the other run.";
        }
        String more = changes.size() > MOST ? ", and " + (changes.size() - MOST) + " more" : "";
        return "Sensors that differ: " + String.join(", ", changes.subList(0, Math.min(MOST, changes.size()))) + more
                + ".";
    }

    private static void addChanges(String id, SensorSettings<?> mine, SensorSettings<?> other, List<String> changes) {
        int before = changes.size();
        if (mine instanceof Record here && other instanceof Record there) {
            Map<String, String> others = new LinkedHashMap<>();
            SettingRow.of(there).forEach(row -> others.put(row.path(), row.value()));
            for (SettingRow row : SettingRow.of(here)) {
                String value = others.getOrDefault(row.path(), SettingRow.NONE);
                if (!value.equals(row.value())) {
                    changes.add("'" + id + "' " + row.path() + " " + shorter(row.value(), value) + " (other run: "
                            + shorter(value, row.value()) + ")");
                }
            }
        }
        if (changes.size() == before) {
            changes.add("'" + id + "'");
        }
    }

    /** A value rounded to {@link #DIGITS} digits, unless both values would then look the same. */
    private static String shorter(String value, String other) {
        String rounded = rounded(value);
        return rounded.equals(rounded(other)) ? value : rounded;
    }

    private static String rounded(String value) {
        return LONG.matcher(value).replaceAll(number -> new BigDecimal(number.group())
                .round(DIGITS)
                .stripTrailingZeros()
                .toPlainString());
    }
}
