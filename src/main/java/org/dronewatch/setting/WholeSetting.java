package org.dronewatch.setting;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** Advice, after a colon, for a user who tried to set a part of a setting that is not set: how to set it as a whole. */
final class WholeSetting {
    /** An example of any number, in the unit of its quantity. */
    private static final String ANY_NUMBER = "10";

    private WholeSetting() {}

    /**
     * Advice about a setting that is not set.
     *
     * @param path path of the setting
     * @param part the component of settings that holds it
     */
    static String unset(String path, RecordComponent part) {
        Class<?> type = part.getGenericType() instanceof ParameterizedType optional
                        && optional.getActualTypeArguments()[0] instanceof Class<?> held
                ? held
                : part.getType();
        List<RecordComponent> written = type.isRecord() ? written(SettingsForm.of(type)) : List.of();
        String example = written.stream()
                .map(one -> ANY_NUMBER + SettingText.quantity(one).displayUnit())
                .collect(Collectors.joining(","));
        try {
            SettingText.parse(part, example);
        } catch (IllegalArgumentException e) {
            return "only a scene file can set it";
        }
        List<String> names = written.stream().map(RecordComponent::getName).toList();
        return "first set "
                + (names.size() == 1 ? names.get(0) : "all of " + String.join(", ", names) + ", in this order")
                + ", as in " + path + "=" + example;
    }

    /**
     * The parts that the text of a record states: all if they are numbers, otherwise the only one without a default.
     */
    private static List<RecordComponent> written(SettingsForm form) {
        return form.isNumbers()
                ? form.parts()
                : form.parts().stream()
                        .filter(part -> form.required().contains(part.getName()))
                        .filter(part -> part.getType() == double.class || part.getType() == int.class)
                        .toList();
    }

    /**
     * Advice about the kind of settings, which cannot be set on its own.
     *
     * @param path path of the settings
     * @param settings class of the settings
     * @return empty if they are not one of several kinds
     */
    static Optional<String> kind(String path, Class<?> settings) {
        return choice(settings).map(type -> {
            Map<String, Class<?>> kinds = Choices.of(type);
            List<String> complete = kinds.keySet().stream()
                    .filter(name -> SettingsForm.of(kinds.get(name)).isCompleteByDefault())
                    .toList();
            if (complete.isEmpty()) {
                return "only a scene file can change the kind of '" + path
                        + "', since each kind needs its own settings";
            }
            return "set '" + path + "' itself to " + String.join(" or ", complete)
                    + (complete.size() == kinds.size() ? "" : "; a scene file can set it to any kind");
        });
    }

    private static Optional<Class<?>> choice(Class<?> settings) {
        Set<Class<?>> types = new LinkedHashSet<>();
        for (Class<?> type = settings; type != null; type = type.getSuperclass()) {
            types.addAll(List.of(type.getInterfaces()));
        }
        Optional<Class<?>> direct = types.stream().filter(Choices::isChoice).findFirst();
        return direct.isPresent()
                ? direct
                : types.stream().flatMap(type -> choice(type).stream()).findFirst();
    }
}
