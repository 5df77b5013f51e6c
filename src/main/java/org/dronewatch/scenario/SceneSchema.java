package org.dronewatch.scenario;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.In;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Switchable;
import org.dronewatch.setting.file.Kinds;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/** Writes the JSON Schema (draft 2020-12) of scene files from the settings records. */
public final class SceneSchema {
    private final JsonMapper json = JsonMapper.builder().build();
    private final Kinds kinds = SensorKinds.kinds(Catalog.packaged());
    private final Map<String, ObjectNode> definitions = new TreeMap<>();
    private final SettingTexts texts;

    public SceneSchema(SettingTexts texts) {
        this.texts = texts;
    }

    /** The schema, with a line break at its end. */
    public String write() {
        ObjectNode root = json.createObjectNode();
        root.put("$schema", "https://json-schema.org/draft/2020-12/schema");
        root.put("title", "dronewatch scene");
        root.put("$ref", reference(SceneSettings.class));
        ObjectNode all = root.putObject("$defs");
        definitions.forEach(all::set);
        return json.writerWithDefaultPrettyPrinter().writeValueAsString(root) + "\n";
    }

    private ObjectNode object() {
        return json.createObjectNode();
    }

    private String reference(Class<?> type) {
        String name =
                type.getName().substring(type.getPackageName().length() + 1).replace('$', '.');
        if (!definitions.containsKey(name)) {
            // First the name, so that types that hold themselves end.
            definitions.put(name, object());
            definitions.put(
                    name, kinds.isChoice(type) ? choice(type) : record(SettingsForm.of(type), Optional.empty()));
        }
        return "#/$defs/" + name;
    }

    private ObjectNode choice(Class<?> type) {
        ObjectNode schema = object();
        ArrayNode any = schema.putArray("anyOf");
        kinds.of(type).forEach((name, kind) -> any.add(record(SettingsForm.of(kind), Optional.of(name))));
        List<String> byName = kinds.of(type).entrySet().stream()
                .filter(kind -> SettingsForm.of(kind.getValue()).isCompleteByDefault())
                .map(Map.Entry::getKey)
                .toList();
        if (!byName.isEmpty() && kinds.named(type).isEmpty()) {
            any.add(names(byName));
        }
        kinds.named(type).ifPresent(named -> {
            ObjectNode known = any.addObject();
            known.put("type", "object");
            ObjectNode use = known.putObject("properties").putObject("use");
            use.put("description", "a sensor of the catalogue, or the name of a file beside this one, without .yaml");
            ArrayNode either = use.putArray("anyOf");
            either.add(names(named.names()));
            either.addObject().put("type", "string");
            known.putArray("required").add("use");
        });
        return schema;
    }

    private ObjectNode names(Collection<String> names) {
        ObjectNode schema = object();
        ArrayNode values = schema.putArray("enum");
        names.forEach(values::add);
        return schema;
    }

    private ObjectNode record(SettingsForm form, Optional<String> kind) {
        ObjectNode schema = object();
        schema.put("type", "object");
        String summary = texts.summary(form.type());
        if (!summary.isEmpty()) {
            schema.put("description", summary);
        }
        ObjectNode properties = schema.putObject("properties");
        kind.ifPresent(name -> properties.putObject("kind").put("const", name));
        kinds.named(form.type()).ifPresent(named -> {
            ObjectNode use = names(named.names());
            use.put("description", "settings of the catalogue to begin with");
            properties.set("use", use);
        });
        Optional<Record> sample = Samples.of(form.type());
        for (RecordComponent part : form.parts()) {
            ObjectNode property = value(part.getGenericType(), Optional.ofNullable(part.getAnnotation(In.class)));
            String text = texts.part(form.type(), part.getName());
            if (!text.isEmpty()) {
                property.put("description", text);
            }
            if (!form.required().contains(part.getName())) {
                sample.ifPresent(defaults -> putDefault(property, SettingsForm.get(defaults, part)));
            }
            properties.set(part.getName(), property);
            putFormerNames(properties, part, property);
            if (part.isAnnotationPresent(Switchable.class)) {
                putSwitch(definitions.get(reference(valueOf(part)).substring("#/$defs/".length())));
            }
        }
        ArrayNode required = schema.putArray("required");
        form.required().stream()
                .filter(name -> !form.renamed().containsValue(name))
                .forEach(required::add);
        putChoiceOfNames(schema, form);
        schema.put("additionalProperties", false);
        return schema;
    }

    /** Accepts the names that a component had before, too. */
    private static void putFormerNames(ObjectNode properties, RecordComponent part, ObjectNode property) {
        Formerly names = part.getAnnotation(Formerly.class);
        for (String former : names == null ? new String[0] : names.value()) {
            ObjectNode old = property.deepCopy();
            old.put("description", "former name of " + part.getName());
            old.put("deprecated", true);
            properties.set(former, old);
        }
    }

    /** Of all names of a component one may be given, and one must be if it has no default. */
    private void putChoiceOfNames(ObjectNode schema, SettingsForm form) {
        for (String name : new LinkedHashSet<>(form.renamed().values())) {
            ArrayNode either = json.createArrayNode();
            either.addObject().putArray("required").add(name);
            form.renamed().forEach((former, current) -> {
                if (current.equals(name)) {
                    either.addObject().putArray("required").add(former);
                }
            });
            if (!form.required().contains(name)) {
                ArrayNode any = json.createArrayNode();
                either.forEach(one -> any.add(one.deepCopy()));
                either.addObject().putObject("not").set("anyOf", any);
            }
            ArrayNode all = schema.has("allOf") ? (ArrayNode) schema.get("allOf") : schema.putArray("allOf");
            all.addObject().set("oneOf", either);
        }
    }

    /** What a component holds by name. */
    private static Class<?> valueOf(RecordComponent map) {
        Type value = ((ParameterizedType) map.getGenericType()).getActualTypeArguments()[1];
        return (Class<?>) (value instanceof ParameterizedType several ? several.getRawType() : value);
    }

    /** Lets each kind be switched off. */
    private static void putSwitch(ObjectNode choice) {
        choice.get("anyOf").forEach(kind -> {
            ObjectNode enabled = ((ObjectNode) kind.get("properties")).putObject(Switchable.ENABLED);
            enabled.put("type", "boolean");
            enabled.put("description", "whether it is switched on; one that is off observes nothing and costs nothing");
            enabled.put("default", true);
        });
    }

    private void putDefault(ObjectNode property, Object value) {
        if (value instanceof Double number) {
            property.put("default", number);
        } else if (value instanceof Integer number) {
            property.put("default", number);
        } else if (value instanceof Long number) {
            property.put("default", number);
        } else if (value instanceof Enum<?> constant) {
            property.put("default", Choices.name(constant.name()));
        } else if (value instanceof String text) {
            property.put("default", text);
        }
    }

    private ObjectNode value(Type type, Optional<In> limits) {
        ObjectNode schema = object();
        if (type instanceof ParameterizedType several) {
            return several(several, limits);
        }
        Class<?> plain = (Class<?>) type;
        if (plain == double.class || plain == Double.class || plain == int.class || plain == long.class) {
            schema.putArray("type")
                    .add(plain == int.class || plain == long.class ? "integer" : "number")
                    .add("string");
            limits.ifPresent(range -> putLimits(schema, range));
        } else if (plain == String.class) {
            schema.putArray("type").add("string").add("number");
        } else if (plain == boolean.class) {
            schema.put("type", "boolean");
        } else if (plain.isEnum()) {
            ArrayNode names = schema.putArray("enum");
            for (Object constant : plain.getEnumConstants()) {
                names.add(Choices.name(((Enum<?>) constant).name()));
            }
        } else if (plain.isRecord() && SettingsForm.of(plain).isNumbers()) {
            putNumbers(schema.putArray("anyOf"), plain);
        } else if (plain.isRecord() && SettingsForm.of(plain).required().size() == 1) {
            ArrayNode any = schema.putArray("anyOf");
            any.addObject().put("$ref", reference(plain));
            SettingsForm form = SettingsForm.of(plain);
            RecordComponent only = form.part(form.required().get(0)).orElseThrow();
            any.add(value(only.getGenericType(), Optional.ofNullable(only.getAnnotation(In.class))));
        } else {
            schema.put("$ref", reference(plain));
        }
        return schema;
    }

    /** As a list of numbers, as one text, or by name. */
    private void putNumbers(ArrayNode any, Class<?> type) {
        int count = SettingsForm.of(type).parts().size();
        ObjectNode list = any.addObject();
        list.put("type", "array");
        list.putObject("items").putArray("type").add("number").add("string");
        list.put("minItems", count);
        list.put("maxItems", count);
        any.addObject().put("type", "string");
        any.addObject().put("$ref", reference(type));
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
            return value(inner[0], limits);
        }
        ObjectNode schema = object();
        if (raw == List.class) {
            schema.put("type", "array");
            schema.set("items", value(inner[0], limits));
        } else if (raw == Map.class) {
            schema.put("type", "object");
            schema.set("additionalProperties", value(inner[1], limits));
        } else {
            schema.put("$ref", reference(raw));
        }
        return schema;
    }
}
