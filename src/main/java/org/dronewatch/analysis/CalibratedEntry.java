package org.dronewatch.analysis;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.CatalogEntry;
import org.dronewatch.catalog.CatalogEntry.Basis;
import org.dronewatch.catalog.CatalogEntry.PublishedRange;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;
import org.dronewatch.world.WorldSettings;

/**
 * The catalogue entry of a calibrated sensor: its settings without position and aim, and its range with the conditions under
 * which it was fitted.
 */
public final class CalibratedEntry {
    private CalibratedEntry() {}

    /**
     * The text of the entry's file.
     *
     * @param scene name of the scene whose conditions hold
     * @param settings of the scene
     * @param sensor name of the sensor
     * @param drone name of the drone
     * @param range the range asked for, m
     * @param probability the probability asked for
     * @param from directory where names of files in the settings start
     * @param file that is to hold the text
     * @throws org.dronewatch.setting.InputException when a setting cannot be written
     */
    public static String text(
            String scene,
            SceneSettings settings,
            String sensor,
            String drone,
            Calibration fit,
            double range,
            double probability,
            Path from,
            Path file) {
        Kinds kinds = SensorKinds.kinds(Catalog.packaged());
        DroneSettings flying = settings.fliers().get(drone);
        Node.Mapping drones = SettingsFile.part(flying, DroneSettings.class, kinds, from, file)
                .without(List.of("flight", "swarm", "label"));
        Node.Mapping world = SettingsFile.part(settings.world(), WorldSettings.class, kinds, from, file)
                .without(List.of("models", "surfaces", "origin", "tracing"));
        Node.Mapping own = SettingsFile.part((Record) fit.sensor(), SensorSettings.class, kinds, from, file)
                .without(List.of("position", "aim"));
        PublishedRange stated = new PublishedRange(
                range,
                "drone '" + drone + "' of " + scene,
                Optional.of(drones),
                world.values().isEmpty() ? Optional.empty() : Optional.of(world));
        CatalogEntry entry = new CatalogEntry(
                "Sensor '" + sensor + "' of " + scene + ", calibrated",
                String.format(
                        Locale.ROOT,
                        "dronewatch calibrate: greatest range %s m, probability %s",
                        number(range),
                        number(probability)),
                Basis.CALIBRATED,
                note(fit),
                "as its settings say",
                Optional.empty(),
                List.of(stated),
                own);
        return "# A sensor for scene files in this directory: {use: NAME}, NAME being the name of this file without .yaml.\n"
                + SettingsFile.text(entry, kinds, file.toAbsolutePath().resolveSibling(""), file);
    }

    private static String note(Calibration fit) {
        return "Fitted with a clear line of sight, without the models of the scene. " + String.join("; ", lines(fit))
                + ".";
    }

    /** What was fitted, and the range of each value, in words. */
    public static List<String> lines(Calibration fit) {
        return new TreeMap<>(fit.ranges())
                .entrySet().stream()
                        .map(value -> fit.scale().setting() + " "
                                + number(value.getKey()) + " "
                                + fit.scale().quantity().unit() + ": " + metres(value.getValue())
                                + (isFitted(value, fit) && fit.ranges().size() > 1 ? " (fitted)" : ""))
                        .toList();
    }

    private static boolean isFitted(Map.Entry<Double, Double> value, Calibration fit) {
        return value.getKey() == fit.threshold();
    }

    private static String metres(double range) {
        return Double.isNaN(range) ? "never" : String.format(Locale.ROOT, "%.3f m", range);
    }

    private static String number(double value) {
        return Double.toString(value).replaceFirst("\\.0$", "");
    }
}
