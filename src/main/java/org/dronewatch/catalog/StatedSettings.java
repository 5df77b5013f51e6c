package org.dronewatch.catalog;

import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Map;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.SettingsForm;

/**
 * The settings that an entry of the library states. They are read only once, since a report compares each of its
 * sensors with all entries.
 *
 * @param name the entry's name
 * @param kind the kind of sensor
 * @param settings the sensor with all its settings
 * @param stated those that the entry states, without aim and detection function
 */
record StatedSettings(String name, String kind, Record settings, List<RecordComponent> stated) {
    /** Those of all entries of the library. */
    static final List<StatedSettings> OF_LIBRARY =
            Catalog.packagedNames().stream().map(StatedSettings::of).toList();

    private static StatedSettings of(String name) {
        CatalogEntry entry = Catalog.packaged().entry(name).orElseThrow();
        Record settings = (Record) Catalog.packaged().settings(name, Map.of("position", new Position(0.0, 0.0, 0.0)));
        List<RecordComponent> stated = SettingsForm.of(settings.getClass()).parts().stream()
                .filter(part -> entry.sensor().values().containsKey(part.getName()))
                .filter(part -> !part.getName().equals("aim") && !part.getName().equals("detection"))
                .toList();
        return new StatedSettings(name, entry.kind(), settings, stated);
    }

    /** The number of these settings that a sensor has; 0 unless it has all of them. */
    int agreeing(SensorSettings<?> sensor) {
        if (!kind.equals(sensor.kind()) || !settings.getClass().isInstance(sensor)) {
            return 0;
        }
        boolean agrees = stated.stream()
                .allMatch(part -> SettingsForm.get((Record) sensor, part).equals(SettingsForm.get(settings, part)));
        return agrees ? stated.size() : 0;
    }
}
