package org.dronewatch.analysis;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.CatalogEntry;
import org.dronewatch.catalog.CatalogEntry.Basis;
import org.dronewatch.catalog.CatalogEntry.PublishedRange;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Condition;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.SoundTracing;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;
import org.dronewatch.world.WorldSettings;

/**
 * The catalogue entry of a calibrated sensor: its settings without position and aim, and the fitted range with the
 * conditions under which it holds. All conditions are stated, including those at their defaults, so that the entry does
 * not depend on the scene.
 *
 * @param scene name of the scene whose conditions are used
 * @param run description of the run of the scene's sweep whose conditions are used; empty if the scene has no sweep
 * @param settings settings of the scene, or of that run
 * @param sensor name of the sensor
 * @param drone name of the drone
 * @param fit the calibration of that sensor
 * @param range the requested range, m
 * @param probability the requested probability
 */
public record CalibratedEntry(
        String scene,
        Optional<String> run,
        SceneSettings settings,
        String sensor,
        String drone,
        Calibration fit,
        double range,
        double probability) {
    /** The first line of every entry's file. */
    public static final Pattern FIRST_LINE = Pattern.compile("# A sensor as calibrated by dronewatch: .*");

    private static final String HEADING =
            "# A sensor as calibrated by dronewatch: scene files in this directory refer to it by"
                    + " {use: NAME}, the name of this file without .yaml.\n";

    /** The components of a world that belong to the place, not to its conditions. */
    private static final List<String> PLACE =
            List.of("models", "terrain", "buildings", "noiseSources", "surfaces", "origin", "tracing");

    /** What every model that listens takes into account, whatever else it ignores of a drone's sound. */
    private static final String GLIDE_REDUCTION = "glideReduction";

    /** How a drone's sound follows from its other settings: stated unless the emission is steady. */
    private static final String EMISSION = "emission";

    private static final String POSITIONER = "positioner";

    /** Ranges are stated in whole millimetres. */
    private static final double PER_METRE = 1e3;

    /**
     * The text of the entry's file.
     *
     * @param from directory against which file names in the settings are resolved
     * @param file the file to which the text will be written
     * @throws org.dronewatch.setting.InputException when a setting cannot be written
     */
    public String text(Path from, Path file) {
        Kinds kinds = SensorKinds.kinds(Catalog.packaged());
        // One of a swarm flies a path that no file can name.
        DroneSettings flying = settings.individualDrones().get(drone).withFlight(Hover.at(new Position(0, 0, 0)));
        List<String> deciding = new ArrayList<>(heard(flying));
        deciding.add("speed");
        Node.Mapping drones = SettingsFile.part(flying, DroneSettings.class, kinds, from, file)
                .without(List.of("flight", "swarm", "label"))
                .without(soundsBut(Set.of()))
                .without(List.of(EMISSION))
                .overlaidWith(only(deciding, SettingsFile.wholePart(flying, DroneSettings.class, kinds, from, file)));
        Node.Mapping world = SettingsFile.wholePart(settings.world(), WorldSettings.class, kinds, from, file)
                .without(PLACE);
        Record fitted = (Record) fit.sensor();
        Node.Mapping own = withoutPlace(SettingsFile.part(fitted, SensorSettings.class, kinds, from, file))
                .overlaidWith(only(
                        List.of("rate", fit.scale().setting().replaceFirst("\\..*", "")),
                        SettingsFile.wholePart(fitted, SensorSettings.class, kinds, from, file)));
        String target = "drone '" + drone + "' of " + scene
                + run.map(swept -> ", " + swept).orElse("");
        PublishedRange stated = new PublishedRange(fittedRange(), target, Optional.of(drones), Optional.of(world));
        CatalogEntry entry = new CatalogEntry(
                "Sensor '" + sensor + "' of " + scene + ", calibrated",
                String.format(
                        Locale.ROOT,
                        "dronewatch calibrate: greatest range %s m, probability %s",
                        number(range),
                        number(probability)),
                Basis.CALIBRATED,
                note(),
                "as stated in its settings",
                Optional.empty(),
                List.of(stated),
                own);
        return HEADING + SettingsFile.text(entry, kinds, file.toAbsolutePath().resolveSibling(""), file);
    }

    /**
     * The settings of a drone's sound that affect how the sensor hears the drone; none if the sensor does not listen.
     * Unless these settings alone determine the sound, all of them count, as does the emission itself, which may use
     * any of them.
     */
    private List<String> heard(DroneSettings flying) {
        SensorSettings<?> fitted = fit.sensor();
        if (fitted.as(SoundTracing.class).isEmpty()) {
            return List.of();
        }
        if (flying.emission().isStatedBySettings()) {
            return soundsBut(fitted.description().ignoredConditions().keySet());
        }
        List<String> all = new ArrayList<>(soundsBut(Set.of()));
        all.add(EMISSION);
        return all;
    }

    /** The settings of a drone's sound except those that a model ignores. */
    private static List<String> soundsBut(Set<Condition> ignored) {
        return Stream.concat(
                        Stream.of(GLIDE_REDUCTION),
                        Arrays.stream(Condition.values())
                                .filter(condition -> !ignored.contains(condition))
                                .flatMap(condition -> condition.droneSetting().stream()))
                .toList();
    }

    /** A sensor without what belongs to its place: other sensors that cue it are not in every scene. */
    private static Node.Mapping withoutPlace(Node.Mapping sensor) {
        Node.Mapping plain = sensor.without(List.of("position", "aim", POSITIONER));
        return sensor.mapping(POSITIONER)
                .map(positioner -> plain.overlaidWith(
                        Node.Mapping.ofNodes(POSITIONER, Map.of(POSITIONER, positioner.without(List.of("cues"))))))
                .orElse(plain);
    }

    /** Settings that the entry states even if they have their default values, since the range depends on them. */
    private static Node.Mapping only(List<String> names, Node.Mapping all) {
        return all.without(all.values().keySet().stream()
                .filter(name -> !names.contains(name))
                .toList());
    }

    /** The range that was fitted, to the millimetre, m. */
    private double fittedRange() {
        return Math.rint(fit.range() * PER_METRE) / PER_METRE;
    }

    private String note() {
        double more = fittedRange() - range;
        String residual = Math.abs(more) * PER_METRE < 1.0
                ? ""
                : String.format(
                        Locale.ROOT,
                        " The fitted range is %.3f m %s than the %s m requested.",
                        Math.abs(more),
                        more > 0.0 ? "greater" : "less",
                        number(range));
        return "Fitted with a clear line of sight, without the models and noise sources of the scene, for a drone that"
                + " approaches at "
                + Quantity.SPEED.inWords(settings.individualDrones().get(drone).speed()) + ", and for a look rate of "
                + Quantity.FREQUENCY.inWords(fit.sensor().rate()) + ". Result: " + String.join("; ", lines(fit)) + "."
                + residual;
    }

    /**
     * One line of text for each value of the threshold, in ascending order, with the greatest range for that value: the
     * fitted value and, if the threshold is a whole number, the values one below and one above it.
     */
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
