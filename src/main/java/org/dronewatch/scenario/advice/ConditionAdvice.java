package org.dronewatch.scenario.advice;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Predicate;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Condition;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.SoundTracing;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.Quantity;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.world.Light;
import org.dronewatch.world.WorldSettings;

/**
 * Warns about weather, light and drone sounds that have no effect, because the models of a scene's sensors do not take
 * them into account.
 */
public final class ConditionAdvice {
    private static final int MOST_NAMES = 3;
    private static final DroneSettings DEFAULT =
            DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(new Position(0, 0, 0)));

    /** What is only ever set for a microphone to hear; the other sounds may come with a kind of drone. */
    private static final Set<Condition> UNHEARD = Set.of(Condition.SPECTRUM, Condition.TONES);

    private final Map<Concern, Set<String>> sensors = new LinkedHashMap<>();
    private final Map<Condition, String> written = new LinkedHashMap<>();
    private final Set<String> unheard = new LinkedHashSet<>();

    private record Concern(Condition condition, String kind, String instead) {}

    private record Subject(String sensors, String instead) {}

    private ConditionAdvice() {}

    /**
     * One line for each kind of sensor and the conditions that it ignores for the same reason; none for a scene with
     * default weather and light, whose drones have no sound settings.
     *
     * @param runs the settings of all runs of a scene
     */
    public static List<String> of(List<SceneSettings> runs) {
        ConditionAdvice advice = new ConditionAdvice();
        runs.forEach(advice::add);
        return advice.lines();
    }

    private void add(SceneSettings scene) {
        for (Condition condition : Condition.values()) {
            setting(scene, condition).ifPresent(text -> {
                written.putIfAbsent(condition, text);
                scene.enabledSensors().forEach((id, sensor) -> add(condition, id, sensor));
                if (UNHEARD.contains(condition) && !listens(scene)) {
                    unheard.add(text);
                }
            });
        }
    }

    private static boolean listens(SceneSettings scene) {
        return scene.enabledSensors().values().stream()
                .anyMatch(sensor -> sensor.as(SoundTracing.class).isPresent());
    }

    private void add(Condition condition, String id, SensorSettings<?> sensor) {
        String instead = sensor.description().ignoredConditions().get(condition);
        if (instead != null) {
            sensors.computeIfAbsent(new Concern(condition, sensor.kind(), instead), concern -> new LinkedHashSet<>())
                    .add(id);
        }
    }

    /** Conditions that the same sensors ignore, and for which the same would help, share a line. */
    private List<String> lines() {
        Map<Subject, List<String>> settings = new LinkedHashMap<>();
        sensors.forEach((concern, ids) -> settings.computeIfAbsent(
                        new Subject(named(concern.kind(), List.copyOf(ids)), concern.instead()),
                        subject -> new ArrayList<>())
                .add(written.get(concern.condition())));
        List<String> lines = new ArrayList<>();
        settings.forEach((subject, ignored) -> lines.add(PlainText.list(ignored)
                + (ignored.size() == 1 ? " does" : " do")
                + " not change what is detected by " + subject.sensors() + ": " + subject.instead()));
        if (!unheard.isEmpty()) {
            lines.add(PlainText.list(List.copyOf(unheard)) + (unheard.size() == 1 ? " has" : " have")
                    + " no effect: the scene has no acoustic sensor");
        }
        return lines;
    }

    /** The setting of a condition with its value, unless it is the default. */
    private static Optional<String> setting(SceneSettings scene, Condition condition) {
        WorldSettings world = scene.world();
        Light light = world.light();
        Light day = Light.DAY;
        return switch (condition) {
            case VISIBILITY ->
                light.visibility() != day.visibility()
                        ? Optional.of("world.light.visibility " + Quantity.LENGTH.inWords(light.visibility()))
                        : light.contrastAtVisibility() != day.contrastAtVisibility()
                                ? Optional.of("world.light.contrastAtVisibility " + light.contrastAtVisibility())
                                : Optional.empty();
            case ILLUMINANCE ->
                light.illuminance() == day.illuminance()
                        ? Optional.empty()
                        : Optional.of("world.light.illuminance " + Quantity.ILLUMINANCE.inWords(light.illuminance()));
            case SUN -> light.sun().map(sun -> "world.light.sun");
            case TURBULENCE ->
                light.cn2() == day.cn2()
                        ? Optional.empty()
                        : Optional.of("world.light.cn2 " + Quantity.REFRACTIVE_INDEX_STRUCTURE.inWords(light.cn2()));
            case GROUND_BRIGHTNESS ->
                light.skyToGroundRatio() == day.skyToGroundRatio()
                        ? Optional.empty()
                        : Optional.of(
                                "world.light.skyToGroundRatio " + Quantity.NUMBER.inWords(light.skyToGroundRatio()));
            case RAIN ->
                world.rain() == 0.0
                        ? Optional.empty()
                        : Optional.of("world.rain " + Quantity.PRECIPITATION.inWords(world.rain()));
            case AIR ->
                world.atmosphere().uniform().equals(Atmosphere.STANDARD)
                        ? Optional.empty()
                        : Optional.of("world.atmosphere");
            case WIND ->
                world.atmosphere().isUniform()
                        ? Optional.empty()
                        : Optional.of(
                                world.atmosphere().wind().speed() > 0.0
                                        ? "world.atmosphere.wind"
                                        : "world.atmosphere.temperatureGradient");
            case NOISE_SOURCES ->
                world.noiseSources().entrySet().stream()
                        .filter(source -> source.getValue().soundLevel().isEmpty())
                        .findFirst()
                        .map(source -> "world.noiseSources." + source.getKey());
            case SOUND_LEVEL -> ofDrone(scene, condition, drone -> setsLevel(drone) && !setsPowerLevel(drone));
            case SOUND_POWER_LEVEL -> ofDrone(scene, condition, drone -> setsPowerLevel(drone) && !setsLevel(drone));
            case SOUND ->
                ofDrone(
                        scene,
                        condition,
                        drone -> drone.spectrum().isEmpty() && !drone.sound().equals(DEFAULT.sound()));
            case DIRECTIVITY -> ofDrone(scene, condition, drone -> drone.directivity() != DEFAULT.directivity());
            case SPECTRUM -> ofDrone(scene, condition, drone -> drone.spectrum().isPresent());
            case TONES -> ofDrone(scene, condition, drone -> drone.tones().isPresent());
        };
    }

    private static boolean setsLevel(DroneSettings drone) {
        return drone.soundLevel() != DEFAULT.soundLevel();
    }

    private static boolean setsPowerLevel(DroneSettings drone) {
        return drone.soundPowerLevel() != DEFAULT.soundPowerLevel();
    }

    /** The setting of the first drone that has it. What another emission makes of its settings is not known here. */
    private static Optional<String> ofDrone(SceneSettings scene, Condition condition, Predicate<DroneSettings> isSet) {
        return scene.drones().entrySet().stream()
                .filter(drone -> drone.getValue().emission().equals(DEFAULT.emission()))
                .filter(drone -> isSet.test(drone.getValue()))
                .findFirst()
                .map(drone -> "drones." + drone.getKey() + "."
                        + condition.droneSetting().orElseThrow());
    }

    private static String named(String kind, List<String> ids) {
        if (ids.size() == 1) {
            return kind + " sensor '" + ids.get(0) + "'";
        }
        int shown = ids.size() <= MOST_NAMES ? ids.size() - 1 : MOST_NAMES - 1;
        String first = "'" + String.join("', '", ids.subList(0, shown)) + "'";
        String rest = ids.size() - shown == 1 ? "'" + ids.get(shown) + "'" : ids.size() - shown + " more";
        return kind + " sensors " + first + " and " + rest;
    }
}
