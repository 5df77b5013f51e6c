package org.dronewatch.scenario;

import java.lang.reflect.RecordComponent;
import java.util.LinkedHashSet;
import java.util.Optional;
import org.dronewatch.setting.Choices;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.file.Kinds;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/** The part of the schema for one settings record: its optional and required properties and their defaults. */
final class RecordSchema {
    private final Kinds kinds;
    private final SettingTexts texts;
    private final ValueSchema values;

    RecordSchema(Kinds kinds, SettingTexts texts, ValueSchema values) {
        this.kinds = kinds;
        this.texts = texts;
        this.values = values;
    }

    /**
     * The schema of a record.
     *
     * @param kind name of the kind by which files choose the record among several
     * @throws IllegalArgumentException when no file can give what it requires
     */
    ObjectNode of(SettingsForm form, Optional<String> kind) {
        ObjectNode schema = JsonNodeFactory.instance.objectNode();
        schema.put("type", "object");
        putDescription(schema, texts.summary(form.type()));
        ObjectNode properties = schema.putObject("properties");
        kind.ifPresent(name -> properties.putObject("kind").put("const", name));
        kinds.named(form.type()).ifPresent(named -> {
            ObjectNode use = ValueSchema.names(named.names());
            use.put("description", "catalogue entry that gives the settings not stated here");
            properties.set("use", use);
        });
        Optional<Record> sample = Samples.of(form.type());
        for (RecordComponent part : form.parts()) {
            if (isWritable(form, part)) {
                ObjectNode property = property(form, part, sample);
                properties.set(part.getName(), property);
                putFormerNames(properties, part, property);
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

    /** Components that only Java code can set are omitted from files, and so from the schema. */
    private boolean isWritable(SettingsForm form, RecordComponent part) {
        boolean writable = values.isWritable(part.getGenericType());
        if (!writable && form.required().contains(part.getName())) {
            throw new IllegalArgumentException("no file can give its setting '" + part.getName() + "' of type "
                    + part.getGenericType().getTypeName());
        }
        return writable;
    }

    private ObjectNode property(SettingsForm form, RecordComponent part, Optional<Record> sample) {
        ObjectNode property = values.of(part);
        String text = texts.part(form.type(), part.getName());
        putDescription(property, text.isEmpty() ? unit(part) : text);
        if (!form.required().contains(part.getName())) {
            sample.ifPresent(defaults -> putDefault(property, SettingsForm.get(defaults, part)));
        }
        return property;
    }

    /** Accepts the former names of a component, too. */
    private static void putFormerNames(ObjectNode properties, RecordComponent part, ObjectNode property) {
        Formerly names = part.getAnnotation(Formerly.class);
        for (String former : names == null ? new String[0] : names.value()) {
            ObjectNode old = property.deepCopy();
            old.put("description", "former name of " + part.getName());
            old.put("deprecated", true);
            properties.set(former, old);
        }
    }

    /** At most one of a component's names may be given, and exactly one if it has no default. */
    private static void putChoiceOfNames(ObjectNode schema, SettingsForm form) {
        for (String name : new LinkedHashSet<>(form.renamed().values())) {
            ArrayNode either = JsonNodeFactory.instance.arrayNode();
            either.addObject().putArray("required").add(name);
            form.renamed().forEach((former, current) -> {
                if (current.equals(name)) {
                    either.addObject().putArray("required").add(former);
                }
            });
            if (!form.required().contains(name)) {
                ArrayNode any = JsonNodeFactory.instance.arrayNode();
                either.forEach(one -> any.add(one.deepCopy()));
                either.addObject().putObject("not").set("anyOf", any);
            }
            ArrayNode all = schema.has("allOf") ? (ArrayNode) schema.get("allOf") : schema.putArray("allOf");
            all.addObject().set("oneOf", either);
        }
    }

    /** The fallback description of an undocumented number: only its unit. */
    private static String unit(RecordComponent part) {
        String unit = SettingText.quantity(part).unit();
        return unit.isEmpty() ? "" : "in " + unit + ", or with a unit";
    }

    private static void putDescription(ObjectNode schema, String text) {
        if (!text.isEmpty()) {
            schema.put("description", text);
        }
    }

    private static void putDefault(ObjectNode property, Object value) {
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
}
