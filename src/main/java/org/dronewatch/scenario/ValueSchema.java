package org.dronewatch.scenario;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.dronewatch.setting.AsNumbers;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.In;
import org.dronewatch.setting.OneForAll;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The part of the schema for one value of a setting: a number, a text, a list, or a reference to a record. */
final class ValueSchema {
    private static final Set<Class<?>> FRACTIONS = Set.of(double.class, Double.class);
    private static final Set<Class<?>> WHOLE = Set.of(int.class, Integer.class, long.class);
    private static final Set<Class<?>> SWITCHES = Set.of(boolean.class, Boolean.class);

    private final Kinds kinds;
    private final Function<Class<?>, String> reference;

    /**
     * Values of settings.
     *
     * @param reference where in the schema the definition of a type is
     */
    ValueSchema(Kinds kinds, Function<Class<?>, String> reference) {
        this.kinds = kinds;
        this.reference = reference;
    }

    /** Whether a file can give a value of a type at all; if not, only Java code can. */
    boolean isWritable(Type type) {
        if (type instanceof ParameterizedType several) {
            Type[] inner = several.getActualTypeArguments();
            Class<?> raw = (Class<?>) several.getRawType();
            boolean holds = raw == Optional.class || raw == List.class || raw == Map.class;
            return holds ? isWritable(inner[inner.length - 1]) : isWritable(raw);
        }
        return type instanceof Class<?> plain
                && (FRACTIONS.contains(plain)
                        || WHOLE.contains(plain)
                        || plain == String.class
                        || SWITCHES.contains(plain)
                        || plain.isEnum()
                        || plain.isRecord()
                        || kinds.isChoice(plain));
    }

    ObjectNode of(RecordComponent part) {
        Optional<In> limits = Optional.ofNullable(part.getAnnotation(In.class));
        return part.isAnnotationPresent(AsNumbers.class)
                ? numbers((Class<?>) part.getType(), List.of())
                : of(part.getGenericType(), limits);
    }

    private static ObjectNode object() {
        return JsonNodeFactory.instance.objectNode();
    }

    private ObjectNode of(Type type, Optional<In> limits) {
        if (type instanceof ParameterizedType several) {
            return several(several, limits);
        }
        Class<?> plain = (Class<?>) type;
        ObjectNode schema = object();
        if (FRACTIONS.contains(plain) || WHOLE.contains(plain)) {
            schema.putArray("type")
                    .add(WHOLE.contains(plain) ? "integer" : "number")
                    .add("string");
            limits.ifPresent(range -> putLimits(schema, range));
        } else if (plain == String.class) {
            schema.putArray("type").add("string").add("number");
        } else if (SWITCHES.contains(plain)) {
            schema.put("type", "boolean");
        } else if (plain.isEnum()) {
            return constants(plain);
        } else if (plain == Node.Mapping.class) {
            // A part of another file, which is checked when it is completed.
            schema.put("type", "object");
        } else if (plain.isRecord() && SettingsForm.of(plain).isNumbers()) {
            return numbers(plain, kinds.otherForms(plain));
        } else if (plain.isRecord() && SettingsForm.of(plain).required().size() == 1) {
            putOnePart(schema.putArray("anyOf"), plain);
        } else {
            schema.put("$ref", reference.apply(plain));
        }
        return schema;
    }

    private static ObjectNode constants(Class<?> type) {
        return names(List.of(type.getEnumConstants()).stream()
                .map(constant -> Choices.name(((Enum<?>) constant).name()))
                .toList());
    }

    /** One of several words. */
    static ObjectNode names(Collection<String> names) {
        ObjectNode schema = object();
        ArrayNode values = schema.putArray("enum");
        names.forEach(values::add);
        return schema;
    }

    /**
     * Allows a value as a list of numbers, as one text, by name, as one number where that represents all, or in another
     * form.
     */
    private ObjectNode numbers(Class<?> type, List<Kinds.OtherForm> others) {
        ObjectNode schema = object();
        ArrayNode any = schema.putArray("anyOf");
        int count = SettingsForm.of(type).parts().size();
        ObjectNode list = any.addObject();
        list.put("type", "array");
        list.putObject("items").putArray("type").add("number").add("string");
        list.put("minItems", count);
        list.put("maxItems", count);
        any.addObject().put("type", "string");
        if (type.isAnnotationPresent(OneForAll.class)) {
            any.addObject().put("type", "number");
        }
        any.addObject().put("$ref", reference.apply(type));
        others.forEach(form -> any.addObject().put("$ref", reference.apply(form.parts())));
        return schema;
    }

    /** Allows a value by name, or by the only part that has no default. */
    private void putOnePart(ArrayNode any, Class<?> type) {
        any.addObject().put("$ref", reference.apply(type));
        SettingsForm form = SettingsForm.of(type);
        any.add(of(form.part(form.required().get(0)).orElseThrow()));
    }

    private static void putLimits(ObjectNode schema, In limits) {
        if (Double.isFinite(limits.from())) {
            schema.put("minimum", limits.from());
        }
        if (Double.isFinite(limits.above())) {
            schema.put("exclusiveMinimum", limits.above());
        }
        if (Double.isFinite(limits.to())) {
            schema.put("maximum", limits.to());
        }
        if (Double.isFinite(limits.below())) {
            schema.put("exclusiveMaximum", limits.below());
        }
    }

    private ObjectNode several(ParameterizedType type, Optional<In> limits) {
        Type[] inner = type.getActualTypeArguments();
        Class<?> raw = (Class<?>) type.getRawType();
        if (raw == Optional.class) {
            return of(inner[0], limits);
        }
        ObjectNode schema = object();
        if (raw == List.class) {
            schema.put("type", "array");
            schema.set("items", of(inner[0], limits));
        } else if (raw == Map.class) {
            schema.put("type", "object");
            schema.set("additionalProperties", of(inner[1], limits));
        } else {
            schema.put("$ref", reference.apply(raw));
        }
        return schema;
    }
}
