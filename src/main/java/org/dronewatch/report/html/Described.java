package org.dronewatch.report.html;

import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;

/** Settings in readable form: names, values and units; angles are in degrees, compass bearings from 0 to 360. */
final class Described {
    private static final String OURS = "org.dronewatch.";
    private static final double TURN = 2.0 * Math.PI;

    /** Angles clockwise from north. */
    private static final Set<String> COMPASS = Set.of("azimuth", "bearing", "heading");

    private Described() {}

    /**
     * The components of a settings record, without minor ones at their defaults.
     *
     * @param without names of components that are shown elsewhere
     */
    static String of(Record settings, Set<String> without) {
        List<String> parts = new ArrayList<>();
        SettingsForm form = SettingsForm.of(settings.getClass());
        for (RecordComponent part : form.parts()) {
            boolean isTrivial = part.isAnnotationPresent(Minor.class) && form.isDefault(settings, part);
            if (!isTrivial && !without.contains(part.getName())) {
                value(onCompass(part, SettingsForm.get(settings, part)), SettingText.quantity(part))
                        .ifPresent(text -> parts.add(words(part.getName()) + " " + text));
            }
        }
        return String.join(", ", parts);
    }

    /** A bearing within one turn of the compass: 375 degrees becomes 15 degrees. */
    private static Object onCompass(RecordComponent part, Object value) {
        return COMPASS.contains(part.getName())
                        && SettingText.quantity(part) == Quantity.ANGLE
                        && value instanceof Double angle
                ? angle - TURN * Math.floor(angle / TURN)
                : value;
    }

    private static Optional<String> value(Object value, Quantity quantity) {
        if (value instanceof Optional<?> optional) {
            return optional.flatMap(inside -> value(inside, quantity));
        }
        if (value instanceof Position position) {
            return Optional.of(
                    String.format(Locale.ROOT, "(%.1f, %.1f, %.1f) m", position.x(), position.y(), position.z()));
        }
        if (value instanceof Record inner) {
            String parts = of(inner, Set.of());
            String kind = Choices.nameOf(inner.getClass());
            if (parts.isEmpty()) {
                return Optional.of(kind);
            }
            // The name is redundant where there is only one kind.
            return Optional.of((isChoice(inner) ? kind + " " : "") + "(" + parts + ")");
        }
        if (value instanceof Number number) {
            return Optional.of(number(number, quantity));
        }
        if (value instanceof Enum<?> constant) {
            return Optional.of(Choices.name(constant.name()));
        }
        if (value instanceof List<?> list && !list.isEmpty() && list.get(0) instanceof Enum<?>) {
            return Optional.of(
                    list.stream().flatMap(one -> value(one, quantity).stream()).collect(Collectors.joining(" and ")));
        }
        if (value instanceof Map<?, ?> map && map.values().stream().anyMatch(Record.class::isInstance)) {
            return Optional.of(map.entrySet().stream()
                    .map(named -> named.getKey() + " "
                            + value(named.getValue(), quantity).orElse(""))
                    .collect(Collectors.joining(", ")));
        }
        boolean empty =
                value instanceof List<?> list && list.isEmpty() || value instanceof Map<?, ?> map && map.isEmpty();
        return empty ? Optional.empty() : Optional.of(String.valueOf(value));
    }

    private static boolean isChoice(Record settings) {
        return Stream.of(settings.getClass().getInterfaces())
                .anyMatch(type -> type.getName().startsWith(OURS) || Choices.isChoice(type));
    }

    private static String number(Number number, Quantity quantity) {
        double value = number.doubleValue();
        if (quantity == Quantity.ANGULAR_SPEED) {
            return quantity.inBrief(value) + "\u00b0/s";
        }
        if (quantity == Quantity.ANGLE) {
            return quantity.inBrief(value) + "\u00b0";
        }
        if (quantity == Quantity.FREQUENCY && value >= 1e6) {
            return value >= 1e9
                    ? Quantity.NUMBER.inBrief(1e-9 * value) + " GHz"
                    : Quantity.NUMBER.inBrief(1e-6 * value) + " MHz";
        }
        return (quantity.inBrief(value) + " " + quantity.unit()).strip();
    }

    /** A component's name in separate words. */
    private static String words(String name) {
        return name.replaceAll("(?<=[a-z])(?=[A-Z])", " ").toLowerCase(Locale.ROOT);
    }
}
