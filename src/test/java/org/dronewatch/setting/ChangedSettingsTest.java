package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.io.IOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Modifier;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.dronewatch.LibraryClasses;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.junit.jupiter.api.Test;

/** Settings are changed by {@code withX}, which gives a new record in which nothing but {@code x} is different. */
class ChangedSettingsTest {
    private record Lamp(@In(value = Quantity.NUMBER, from = 0.0, to = 100.0) double watts, String colour) {
        Lamp {
            Limits.check(Lamp.class, watts, colour);
        }
    }

    private static final Lamp LAMP = new Lamp(40.0, "white");

    @Test
    void onePartIsChangedAndTheRecordThatWasIsNot() {
        assertThat(SettingsForm.with(LAMP, "watts", 60.0)).isEqualTo(new Lamp(60.0, "white"));
        assertThat(SettingsForm.with(LAMP, Map.of("watts", 5, "colour", "red"))).isEqualTo(new Lamp(5.0, "red"));
        assertThat(LAMP).isEqualTo(new Lamp(40.0, "white"));
    }

    @Test
    void limitsHoldForWhatIsChanged() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SettingsForm.with(LAMP, "watts", 101.0))
                .withMessageStartingWith("watts 101");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SettingsForm.with(LAMP, "colour", null))
                .withMessage("colour is missing");
    }

    @Test
    void aPartThatTheRecordHasNotIsRefused() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> SettingsForm.with(LAMP, "wats", 60.0))
                .withMessageEndingWith("Lamp has no component wats");
    }

    /** A {@code withX} that changes one component, its own or one that several records inherit. */
    private record Wither(Record settings, Method method) {}

    /** Those of all records of the library that can be made with little. */
    private static List<Wither> withers() throws IOException {
        List<Wither> found = new ArrayList<>();
        for (Class<?> one : LibraryClasses.all()) {
            if (one.isRecord() && Modifier.isPublic(one.getModifiers())) {
                byDefault(one)
                        .ifPresent(settings -> Stream.of(settings.getClass().getMethods())
                                .filter(method -> method.getName().matches("with[A-Z].*")
                                        && method.getParameterCount() == 1
                                        && !method.isBridge()
                                        && component(settings, method).isPresent())
                                .forEach(method -> found.add(new Wither(settings, method))));
            }
        }
        return found;
    }

    private static Optional<Record> byDefault(Class<?> type) {
        SettingsForm form = SettingsForm.of(type);
        Map<String, Object> known = Map.of(
                "position", new Position(1, 2, 3),
                "budget", LinkBudget.DataSheet.of(1000.0, 1.0),
                "file", "hill.obj",
                "model", ModelSettings.of("drone.obj"),
                "flight", Hover.at(new Position(4, 5, 6)));
        Map<String, Object> needed = new HashMap<>(known);
        needed.keySet().retainAll(form.required());
        boolean hasDefaults = form.required().size() < form.parts().size();
        return hasDefaults && known.keySet().containsAll(form.required())
                ? Optional.of(form.create(needed))
                : Optional.empty();
    }

    private static Optional<RecordComponent> component(Record settings, Method wither) {
        String name = wither.getName().substring("with".length());
        return SettingsForm.of(settings.getClass())
                .part(Character.toLowerCase(name.charAt(0)) + name.substring(1))
                .filter(part -> part.getType() == wither.getParameterTypes()[0]);
    }

    /** Another value of a component, within its limits: one that the record accepts. */
    private static Optional<Object> other(Record settings, RecordComponent part) {
        Object now = SettingsForm.get(settings, part);
        Stream<Object> candidates = now instanceof Double number
                ? Stream.of(0.9 * number + 0.01, 0.5 * number, number + 1.0)
                : now instanceof Integer number
                        ? Stream.of(number + 1, number - 1)
                        : now instanceof Enum<?> constant
                                ? Arrays.<Object>stream(
                                        constant.getDeclaringClass().getEnumConstants())
                                : now instanceof Boolean flag
                                        ? Stream.of(!flag)
                                        : now instanceof Position at ? Stream.of(at.plus(at)) : Stream.of();
        return candidates
                .filter(value -> !value.equals(now))
                .filter(value -> isAllowed(settings, part, value))
                .findFirst();
    }

    private static boolean isAllowed(Record settings, RecordComponent part, Object value) {
        try {
            return SettingsForm.with(settings, part.getName(), value) != null;
        } catch (IllegalArgumentException e) {
            return false;
        }
    }

    @Test
    void everyWitherOfTheLibraryChangesWhatItIsNamedAfterAndNothingElse()
            throws ReflectiveOperationException, IOException {
        int changed = 0;
        List<Wither> withers = withers();
        for (Wither one : withers) {
            Method wither = one.method();
            Record before = one.settings();
            RecordComponent part = component(before, wither).orElseThrow();
            assertThat(call(wither, before, SettingsForm.get(before, part)))
                    .as(wither.toString())
                    .isEqualTo(before);
            Optional<Object> other = other(before, part);
            if (other.isPresent()) {
                Object after = call(wither, before, other.get());
                assertThat(after)
                        .as(wither.toString())
                        .isEqualTo(SettingsForm.with(before, part.getName(), other.get()))
                        .isNotEqualTo(before);
                changed++;
            }
        }
        assertThat(new TreeSet<>(withers.stream()
                        .map(one -> one.settings().getClass().getSimpleName())
                        .toList()))
                .contains(
                        "CameraSettings",
                        "ThermalSettings",
                        "RadarSettings",
                        "AcousticSettings",
                        "DroneSettings",
                        "ModelSettings");
        assertThat(changed).isGreaterThan(30);
    }

    private static Object call(Method wither, Record settings, Object value)
            throws ReflectiveOperationException, IOException {
        try {
            return wither.invoke(settings, value);
        } catch (InvocationTargetException e) {
            throw new AssertionError(wither + " of " + value, e.getCause());
        }
    }
}
