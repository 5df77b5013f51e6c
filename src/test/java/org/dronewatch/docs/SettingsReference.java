package org.dronewatch.docs;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.scenario.PlaceForms;
import org.dronewatch.scenario.Samples;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Switchable;
import org.dronewatch.setting.file.Kinds;

/** Writes the page that lists every setting with unit, range and default, from the settings records. */
final class SettingsReference {
    private final Kinds kinds = PlaceForms.in(SensorKinds.kinds(Catalog.packaged()));
    private final Set<Class<?>> waiting = new LinkedHashSet<>();
    private final Set<Type> switchable = new HashSet<>();
    private final Set<Class<?>> written = new LinkedHashSet<>();
    private final StringBuilder page = new StringBuilder();
    private final RecordTexts texts;

    SettingsReference(RecordTexts texts) {
        this.texts = texts;
    }

    String write() {
        page.append("# All settings\n\n")
                .append(
                        "The fields of a scene file, the paths of `--set` and the components of the settings records of the"
                                + " Java library\nare the same. This page is generated from the records; a test keeps it up to"
                                + " date.\n\n"
                                + "A number is in the unit given in the table or carries a unit (`18 km/h`, `40 deg`, `70 %`); an angle"
                                + " without a unit is\nin radians, although ranges and defaults are given in degrees here. A setting"
                                + " without a default is required,\nexcept that a scene requires only `world`. Where a setting has"
                                + " several kinds, `kind` selects one; it may be\nomitted where the other fields determine it.\n\n"
                                + "Former names of settings still work, with a warning; `save` writes the current ones.\n");
        waiting.add(SceneSettings.class);
        while (!waiting.isEmpty()) {
            Class<?> next = waiting.iterator().next();
            waiting.remove(next);
            if (written.add(next)) {
                if (next.isRecord()) {
                    record(next);
                } else {
                    choice(next);
                }
            }
        }
        return page.toString();
    }

    private void choice(Class<?> type) {
        heading(type);
        page.append("One of these kinds:\n\n");
        for (Map.Entry<String, Class<?>> kind : kinds.of(type).entrySet()) {
            page.append("- `")
                    .append(kind.getKey())
                    .append("`: [")
                    .append(title(kind.getValue()))
                    .append("](#")
                    .append(anchor(kind.getValue()))
                    .append(")\n");
            waiting.add(kind.getValue());
        }
        if (kinds.named(type).isPresent()) {
            page.append(
                    "- or `use: NAME` instead of a kind: a sensor from the catalogue, or from a file next to the scene file\n");
        }
        if (switchable.contains(type)) {
            page.append(
                    "\nIn addition to the settings of its kind, `enabled: false` switches a sensor off (`true` by default).\n");
        }
    }

    private void heading(Class<?> type) {
        page.append("\n## ").append(title(type)).append("\n\n");
    }

    private void record(Class<?> type) {
        heading(type);
        page.append(texts.summary(type)).append("\n\n");
        kinds.named(type).ifPresent(named -> page.append("`use` starts from an entry of the catalogue: `")
                .append(String.join("`, `", named.names()))
                .append("`.\n\n"));
        List<Kinds.OtherForm> others = kinds.otherForms(type);
        if (!others.isEmpty()) {
            page.append(
                            "Instead, scene files may use one of these forms, which the page on [places](places.md) explains: ")
                    .append(others.stream()
                            .map(form -> "[" + title(form.parts()) + "](#" + anchor(form.parts()) + ")")
                            .collect(Collectors.joining(", ")))
                    .append(".\n\n");
            others.forEach(form -> waiting.add(form.parts()));
        }
        page.append("| setting | unit | range | default | what it is |\n|---|---|---|---|---|\n");
        SettingsForm form = SettingsForm.of(type);
        Optional<Record> sample = Samples.of(type);
        for (RecordComponent part : form.parts()) {
            if (part.isAnnotationPresent(Switchable.class)) {
                Type value = ((ParameterizedType) part.getGenericType()).getActualTypeArguments()[1];
                switchable.add(value instanceof ParameterizedType several ? several.getRawType() : value);
            }
            In limits = part.getAnnotation(In.class);
            Optional<Object> standard = form.required().contains(part.getName())
                    ? Optional.empty()
                    : sample.map(settings -> SettingsForm.get(settings, part));
            page.append("| `")
                    .append(part.getName())
                    .append("` | ")
                    .append(limits == null ? "" : SettingText.quantity(part).unit())
                    .append(" | ")
                    .append(limits == null ? range(part.getGenericType()) : Limits.inWords(limits))
                    .append(" | ")
                    .append(standard.map(value -> standard(value, SettingText.quantity(part)))
                            .orElse(""))
                    .append(" | ")
                    .append(described(texts.part(type, part.getName()), SettingText.quantity(part)))
                    .append(formerly(part))
                    .append(" |\n");
        }
    }

    private static String formerly(RecordComponent part) {
        Formerly names = part.getAnnotation(Formerly.class);
        return names == null ? "" : " (formerly `" + String.join("`, `", names.value()) + "`)";
    }

    /**
     * What has a column of its own is left out: a unit at the end, and the range of an angle in radians, which the
     * column gives in degrees.
     */
    private static String described(String text, Quantity quantity) {
        boolean turned = quantity == Quantity.ANGLE || quantity == Quantity.ANGULAR_SPEED;
        String unit = quantity.unit();
        String end = turned
                ? "(, (above 0|-?\\d* ?pi|[\\d.]+ (to|degrees))[^,]*)?,? rad(/s)?$"
                : unit.isEmpty() ? "$" : ", " + Pattern.quote(unit) + "$";
        return text.replaceFirst(end, "").replace("|", "\\|");
    }

    /** What may stand there that is no number; what has parts of its own follows later on the page. */
    private String range(Type type) {
        if (type instanceof ParameterizedType several) {
            Type[] inner = several.getActualTypeArguments();
            Class<?> raw = (Class<?>) several.getRawType();
            if (raw == List.class) {
                return "list: " + range(inner[0]);
            }
            if (raw == Map.class) {
                return "by name: " + (inner[1] == Double.class ? "number" : range(inner[1]));
            }
            return raw == Optional.class ? range(inner[0]) : range(raw);
        }
        Class<?> plain = (Class<?>) type;
        if (plain.isEnum()) {
            return String.join(
                    ", ",
                    List.of(plain.getEnumConstants()).stream()
                            .map(constant -> "`" + Choices.name(((Enum<?>) constant).name()) + "`")
                            .toList());
        }
        if (plain == String.class) {
            return "text";
        }
        if (plain == long.class) {
            return "whole number";
        }
        if (plain.isRecord() || kinds.isChoice(plain)) {
            waiting.add(plain);
            return "[" + title(plain) + "](#" + anchor(plain) + ")";
        }
        return "";
    }

    private String standard(Object value, Quantity quantity) {
        if (value instanceof Double angle && quantity == Quantity.ANGLE) {
            return standard(Math.toDegrees(angle)) + " deg";
        }
        if (value instanceof Double angle && quantity == Quantity.ANGULAR_SPEED) {
            return standard(Math.toDegrees(angle)) + " deg/s";
        }
        return standard(value);
    }

    /** Settings that have a default as a whole, while their own table has none for some of them. */
    private String byName(SettingsForm form, Record settings) {
        return form.parts().stream()
                .map(part -> part.getName() + ": " + standard(SettingsForm.get(settings, part)))
                .collect(Collectors.joining(", ", "{", "}"));
    }

    private String standard(Object value) {
        if (value instanceof Double number) {
            return String.format(Locale.ROOT, "%.6g", number)
                    .replaceAll("(\\.\\d*?)0+(e|$)", "$1$2")
                    .replaceAll("\\.(e|$)", "$1")
                    .replaceAll("e\\+?(-?)0*", "e$1");
        }
        if (value instanceof Integer || value instanceof Long) {
            return value.toString();
        }
        if (value instanceof Enum<?> constant) {
            return "`" + Choices.name(constant.name()) + "`";
        }
        if (value instanceof String text) {
            return "`" + text + "`";
        }
        if (value instanceof Record settings) {
            if (isOneOfSeveral(settings)) {
                return "`" + Choices.nameOf(value.getClass()) + "`";
            }
            SettingsForm form = SettingsForm.of(value.getClass());
            if (form.isNumbers()) {
                return numbers(settings);
            }
            return form.isCompleteByDefault() ? "see its table" : "`" + byName(form, settings) + "`";
        }
        if (value instanceof Optional<?> optional) {
            return optional.isEmpty() ? "none" : standard(optional.get());
        }
        if (value instanceof Map<?, ?> map && map.isEmpty() || value instanceof List<?> list && list.isEmpty()) {
            return "none";
        }
        if (value instanceof List<?> list && list.get(0) instanceof Enum<?>) {
            return list.stream().map(this::standard).collect(Collectors.joining(", "));
        }
        return value.toString();
    }

    private boolean isOneOfSeveral(Record settings) {
        return List.of(settings.getClass().getInterfaces()).stream().anyMatch(kinds::isChoice);
    }

    private String numbers(Record settings) {
        return String.join(
                ", ",
                SettingsForm.of(settings.getClass()).parts().stream()
                        .map(part -> standard(SettingsForm.get(settings, part)))
                        .toList());
    }

    /** {@code RadarSettings}: "Radar settings". */
    private static String title(Class<?> type) {
        String words = Choices.name(type.getSimpleName()).replace('-', ' ');
        String sentence = words.substring(0, 1).toUpperCase(Locale.ROOT) + words.substring(1);
        return sentence.replace("Rf ", "RF ").replace("Sah ", "SAH ").replace("Pop up", "Pop-up");
    }

    private static String anchor(Class<?> type) {
        return Choices.name(type.getSimpleName());
    }
}
