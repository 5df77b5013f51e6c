package org.dronewatch.scene;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Switchable;
import org.dronewatch.setting.file.Kinds;
import tools.jackson.databind.json.JsonMapper;

/** Writes a settings record as a file that says the same, in that part of YAML which is JSON. */
final class SettingsText {
    private final Kinds kinds;

    private final Function<RecordComponent, String> names;

    private SettingsText(Kinds kinds, Function<RecordComponent, String> names) {
        this.kinds = kinds;
        this.names = names;
    }

    static String of(Record settings, Kinds kinds) {
        return of(settings, kinds, RecordComponent::getName);
    }

    /** The same with other names of the components. */
    static String of(Record settings, Kinds kinds, Function<RecordComponent, String> names) {
        return JsonMapper.shared()
                        .writerWithDefaultPrettyPrinter()
                        .writeValueAsString(new SettingsText(kinds, names).record(settings, settings.getClass()))
                + "\n";
    }

    private Map<String, Object> record(Record settings, Type declared) {
        Map<String, Object> document = new LinkedHashMap<>();
        Class<?> type = (Class<?>) (declared instanceof ParameterizedType several ? several.getRawType() : declared);
        if (kinds.isChoice(type)) {
            kinds.of(type).forEach((name, kind) -> {
                if (kind == settings.getClass()) {
                    document.put("kind", name);
                }
            });
        }
        for (RecordComponent part : SettingsForm.of(settings.getClass()).parts()) {
            Object value = SettingsForm.get(settings, part);
            if (!(value instanceof Optional<?> optional && optional.isEmpty())) {
                document.put(names.apply(part), value(value, part.getGenericType()));
            }
            if (part.isAnnotationPresent(Switchable.class)) {
                RecordComponent off = SettingsForm.of(settings.getClass()).switchOf(part);
                for (Object name : (Set<?>) SettingsForm.get(settings, off)) {
                    Map<?, ?> all = (Map<?, ?>) document.get(names.apply(part));
                    @SuppressWarnings("unchecked")
                    Map<String, Object> one = (Map<String, Object>) all.get(name);
                    one.put(Switchable.ENABLED, false);
                }
            }
        }
        return document;
    }

    private Object value(Object value, Type declared) {
        Type[] inner = declared instanceof ParameterizedType several ? several.getActualTypeArguments() : new Type[0];
        if (value instanceof Optional<?> optional) {
            return value(optional.orElseThrow(), inner[0]);
        }
        if (value instanceof List<?> list) {
            return list.stream().map(item -> value(item, inner[0])).toList();
        }
        if (value instanceof Map<?, ?> map) {
            Map<String, Object> document = new LinkedHashMap<>();
            map.forEach((name, item) -> document.put(name.toString(), value(item, inner[1])));
            return document;
        }
        if (value instanceof Enum<?> constant) {
            return Choices.name(constant.name());
        }
        return value instanceof Record settings ? record(settings, declared) : value;
    }
}
