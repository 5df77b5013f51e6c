package org.dronewatch.scenario;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.setting.FoundKind;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Switchable;
import org.dronewatch.setting.file.Kinds;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;

/**
 * Writes the JSON Schema (draft 2020-12) of scene files, with which editors complete and check these files; it is
 * derived from the settings records of all kinds on the class path. Each object writes a single schema, and is for use
 * by one thread.
 */
public final class SceneSchema {
    private static final String DEFINITIONS = "#/$defs/";

    private final JsonMapper json = JsonMapper.builder().build();
    private final Kinds kinds = PlaceForms.in(SensorKinds.kinds(Catalog.packaged()));
    private final Map<String, ObjectNode> definitions = new TreeMap<>();
    private final RecordSchema records;

    /**
     * A schema with these descriptions of settings.
     *
     * @param texts the descriptions, such as {@link PackagedTexts}
     */
    public SceneSchema(SettingTexts texts) {
        this.records = new RecordSchema(kinds, texts, new ValueSchema(kinds, this::reference));
    }

    /**
     * The schema, with a line break at its end; the same for the same class path.
     *
     * @throws InputException when the settings of a kind cannot be described, in one line that names its jar
     */
    public String write() {
        return write("dronewatch scene", SceneSettings.class);
    }

    /**
     * The schema of other files that are read with the kinds of scene files; the same for the same class path.
     *
     * @param title what the files are
     * @param type record that the files describe
     */
    public String write(String title, Class<? extends Record> type) {
        ObjectNode root = json.createObjectNode();
        root.put("$schema", "https://json-schema.org/draft/2020-12/schema");
        root.put("title", title);
        root.put("$ref", reference(type));
        ObjectNode all = root.putObject("$defs");
        definitions.forEach(all::set);
        return json.writerWithDefaultPrettyPrinter().writeValueAsString(root) + "\n";
    }

    private String reference(Class<?> type) {
        String name = name(type);
        if (!definitions.containsKey(name)) {
            // First the name, so that recursive types terminate.
            definitions.put(name, json.createObjectNode());
            definitions.put(
                    name, kinds.isChoice(type) ? choice(type) : records.of(SettingsForm.of(type), Optional.empty()));
            if (type.isRecord()) {
                putSwitches(SettingsForm.of(type));
            }
        }
        return DEFINITIONS + name;
    }

    /** Third-party types have their fully qualified name, which no type of the library has. */
    private static String name(Class<?> type) {
        String whole = type.getName();
        return (FoundKind.isBuiltIn(type)
                        ? whole.substring(type.getPackageName().length() + 1)
                        : whole)
                .replace('$', '.');
    }

    private ObjectNode choice(Class<?> type) {
        ObjectNode schema = json.createObjectNode();
        ArrayNode any = schema.putArray("anyOf");
        kinds.of(type).forEach((name, settings) -> any.add(kind(name, settings)));
        List<String> byName = kinds.of(type).entrySet().stream()
                .filter(kind -> SettingsForm.of(kind.getValue()).isCompleteByDefault())
                .map(Map.Entry::getKey)
                .toList();
        if (!byName.isEmpty() && kinds.named(type).isEmpty()) {
            any.add(ValueSchema.names(byName));
        }
        kinds.named(type).ifPresent(named -> putUse(any.addObject(), named));
        return schema;
    }

    private ObjectNode kind(String name, Class<?> settings) {
        try {
            return records.of(SettingsForm.of(settings), Optional.of(name));
        } catch (RuntimeException | LinkageError e) {
            // The library's own kinds are tested; what goes wrong in another jar is for its author to know.
            if (e instanceof InputException || FoundKind.isBuiltIn(settings)) {
                throw e;
            }
            throw new InputException(
                    "kind '" + name + "' from " + FoundKind.originOf(settings) + ": its settings cannot be described: "
                            + PlainText.value(e.getMessage()),
                    e);
        }
    }

    private static void putUse(ObjectNode known, Kinds.NamedSettings named) {
        known.put("type", "object");
        ObjectNode use = known.putObject("properties").putObject("use");
        use.put("description", "a sensor of the catalogue, or the name of a file next to this one, without .yaml");
        ArrayNode either = use.putArray("anyOf");
        either.add(ValueSchema.names(named.names()));
        either.addObject().put("type", "string");
        known.putArray("required").add("use");
    }

    /** Allows each entry of a map component to be disabled with {@code enabled: false}. */
    private void putSwitches(SettingsForm form) {
        for (RecordComponent part : form.parts()) {
            if (part.isAnnotationPresent(Switchable.class)) {
                String definition = reference(valueOf(part)).substring(DEFINITIONS.length());
                definitions
                        .get(definition)
                        .get("anyOf")
                        .forEach(kind -> putSwitch((ObjectNode) kind.get("properties")));
            }
        }
    }

    /** The value type of a map component. */
    private static Class<?> valueOf(RecordComponent map) {
        Type value = ((ParameterizedType) map.getGenericType()).getActualTypeArguments()[1];
        return (Class<?>) (value instanceof ParameterizedType several ? several.getRawType() : value);
    }

    private static void putSwitch(ObjectNode properties) {
        ObjectNode enabled = properties.putObject(Switchable.ENABLED);
        enabled.put("type", "boolean");
        enabled.put("description", "whether it is switched on; one that is off observes nothing and costs nothing");
        enabled.put("default", true);
    }
}
