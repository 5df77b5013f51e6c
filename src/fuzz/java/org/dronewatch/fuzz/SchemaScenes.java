package org.dronewatch.fuzz;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.ObjectNode;
import tools.jackson.dataformat.yaml.YAMLMapper;

/** Random scenes that the schema of scene files allows, most of them cheap to run. */
final class SchemaScenes {
    private static final JsonNode SCHEMA =
            JsonMapper.shared().readTree(Path.of("scenes", "scene.schema.json").toFile());
    private static final List<String> SURFACES = List.of("grass_turf", "brick_rough", "limestone", "solid");

    /** Texts that the schema leaves open. */
    private static final Map<String, List<String>> TEXTS = Map.of(
            "file", List.of("site.obj", "drone.obj"),
            "model", List.of("drone.obj"),
            "models", List.of("site.obj"),
            "defaultSurface", SURFACES,
            "sound", List.of("c1-quadrotor", "hexacopter"),
            "currency", List.of("EUR", "K\u010D"));

    /** Settings that cost time, with the values up to which they are cheap. */
    private static final Map<String, Integer> CHEAP = Map.ofEntries(
            Map.entry("width", 96),
            Map.entry("height", 64),
            Map.entry("rays", 300),
            Map.entry("initialRays", 20),
            Map.entry("reflectionsPerHit", 6),
            Map.entry("rayBudget", 3000),
            Map.entry("maxOrder", 5),
            Map.entry("pulses", 20),
            Map.entry("imageSourceOrder", 2),
            Map.entry("rate", 20),
            Map.entry("rows", 4),
            Map.entry("swarm", 3),
            Map.entry("count", 3));

    private static final int MOST_LOOKS = 12;

    private final Dice dice;
    private final boolean large;
    private final List<ArrayNode> places = new ArrayList<>();
    private final Set<String> sensors = new HashSet<>();
    private String largeSensor = "";
    private String sensor = "";
    private double fastest = 1;

    SchemaScenes(Dice dice, boolean large) {
        this.dice = dice;
        this.large = large;
    }

    /** The text of a scene file. */
    String scene() {
        JsonNode definitions = SCHEMA.get("$defs");
        ObjectNode scene = JsonMapper.shared().createObjectNode();
        scene.set("world", object(definitions.get("WorldSettings"), 0));
        ObjectNode drones = scene.putObject("drones");
        for (int i = dice.between(1, 3); i > 0; i--) {
            drones.set("d" + i, value("", definitions.get("DroneSettings"), 0));
        }
        ObjectNode placed = scene.putObject("sensors");
        int count = dice.between(1, 4);
        for (int i = 1; i <= count; i++) {
            sensors.add("s" + i);
        }
        for (String name : sensors) {
            sensor = name;
            ObjectNode settings = (ObjectNode) value("", definitions.get("SensorSettings"), 0);
            // The schema does not demand it, because an entry of the catalogue may have it.
            settings.set("position", place());
            placed.set(name, settings);
        }
        if (dice.oneIn(3)) {
            scene.set("alert", value("", definitions.get("AlertSettings"), 0));
        }
        ObjectNode run = scene.putObject("run");
        run.put("duration", Math.min(dice.pick(0.3, 1.0, 2.5), MOST_LOOKS / fastest));
        run.put("seed", dice.random().nextInt());
        return YAMLMapper.shared().writeValueAsString(scene);
    }

    /** The sensor with the large picture; empty if there is none. */
    String largeSensor() {
        return largeSensor;
    }

    private JsonNode value(String name, JsonNode schema, int depth) {
        if (name.equals("cues")) {
            ArrayNode cues = JsonMapper.shared().createArrayNode();
            cues.add(dice.pick(List.copyOf(sensors)));
            return cues;
        }
        if (schema.has("$ref")) {
            String definition = schema.get("$ref").asString().replaceFirst(".*/", "");
            return definition.equals("Position")
                    ? place()
                    : value(name, SCHEMA.get("$defs").get(definition), depth);
        }
        if (schema.has("anyOf")) {
            return value(name, choice(schema.get("anyOf")), depth);
        }
        if (schema.has("const")) {
            return schema.get("const");
        }
        if (schema.has("enum")) {
            return schema.get("enum").get(dice.below(schema.get("enum").size()));
        }
        String type = schema.get("type").isArray()
                ? schema.get("type").get(0).asString()
                : schema.get("type").asString();
        return switch (type) {
            case "object" -> object(schema, depth);
            case "array" -> array(name, schema, depth);
            case "boolean" -> JsonMapper.shared().getNodeFactory().booleanNode(dice.oneIn(2));
            case "string" -> JsonMapper.shared().getNodeFactory().stringNode(text(name));
            case "integer" ->
                JsonMapper.shared().getNodeFactory().numberNode((long)
                        Math.max(least(schema), Math.rint(number(name, schema))));
            default -> JsonMapper.shared().getNodeFactory().numberNode(number(name, schema));
        };
    }

    /** One of several forms; plain texts only where they are the only one. */
    private JsonNode choice(JsonNode forms) {
        List<JsonNode> open = new ArrayList<>();
        for (JsonNode form : forms) {
            boolean text = form.has("type")
                    && form.get("type").isString()
                    && form.get("type").asString().equals("string");
            if (!text) {
                open.add(form);
            }
        }
        // Numbers in a list have no limits in the schema; mostly, settings by name are chosen, which have limits.
        List<JsonNode> named = open.stream().filter(form -> form.has("$ref")).toList();
        return dice.pick(named.isEmpty() || dice.oneIn(6) ? open : named);
    }

    private ObjectNode object(JsonNode schema, int depth) {
        ObjectNode object = JsonMapper.shared().createObjectNode();
        Set<String> required = new HashSet<>();
        if (schema.has("required")) {
            schema.get("required").forEach(name -> required.add(name.asString()));
        }
        if (schema.has("allOf")) {
            // The present name of a setting comes first.
            schema.get("allOf").forEach(names -> addIfRequired(names.get("oneOf"), required));
        }
        if (schema.has("properties")) {
            schema.get("properties").properties().forEach(part -> {
                boolean kind = part.getValue().has("const") || CHEAP.containsKey(part.getKey());
                boolean use = part.getKey().equals("use") && !required.contains("use");
                boolean former = part.getValue().has("deprecated");
                if (!use && !former && (required.contains(part.getKey()) || kind || dice.oneIn(3 + depth))) {
                    object.set(part.getKey(), value(part.getKey(), part.getValue(), depth + 1));
                }
            });
        } else if (schema.has("additionalProperties")
                && schema.get("additionalProperties").isObject()) {
            object.put(dice.pick("grass", "brick"), dice.pick(SURFACES));
        }
        return object;
    }

    private static void addIfRequired(JsonNode names, Set<String> required) {
        boolean mayBeLeftOut = names.get(names.size() - 1).has("not");
        if (!mayBeLeftOut) {
            required.add(names.get(0).get("required").get(0).asString());
        }
    }

    private JsonNode array(String name, JsonNode schema, int depth) {
        int least = schema.has("minItems") ? schema.get("minItems").asInt() : 1;
        int most = schema.has("maxItems") ? schema.get("maxItems").asInt() : Math.max(least + 2, 3);
        if (least == 3 && most == 3) {
            return place();
        }
        ArrayNode array = JsonMapper.shared().createArrayNode();
        for (int i = dice.between(name.equals("points") ? 2 : least, most); i > 0; i--) {
            array.add(value(name, schema.get("items"), depth + 1));
        }
        return array;
    }

    /** A place on the site or near it, seldom far away. */
    private ArrayNode place() {
        // One of the other places again, so that what is looked at is where a drone is.
        if (!places.isEmpty() && dice.oneIn(4)) {
            return dice.pick(places).deepCopy();
        }
        places.add(newPlace());
        return places.get(places.size() - 1).deepCopy();
    }

    private ArrayNode newPlace() {
        double reach = dice.oneIn(30) ? Math.pow(10, dice.between(3, 12)) : 80;
        ArrayNode place = JsonMapper.shared().createArrayNode();
        place.add(dice.between(-reach, reach));
        place.add(dice.between(-reach, reach));
        place.add(dice.oneIn(8) ? dice.between(-reach, reach) : dice.between(10.5, 40.0));
        return place;
    }

    private String text(String name) {
        return dice.pick(TEXTS.getOrDefault(name, List.of("solid")));
    }

    private static double least(JsonNode schema) {
        return schema.has("minimum") ? schema.get("minimum").asDouble() : Long.MIN_VALUE;
    }

    private double number(String name, JsonNode schema) {
        if (CHEAP.containsKey(name) && schema.has("maximum")) {
            return cheap(name, schema);
        }
        double low = schema.has("minimum") ? schema.get("minimum").asDouble() : Double.NaN;
        double high = schema.has("maximum") ? schema.get("maximum").asDouble() : Double.NaN;
        low = schema.has("exclusiveMinimum")
                ? Math.nextUp(schema.get("exclusiveMinimum").asDouble())
                : low;
        high = schema.has("exclusiveMaximum")
                ? Math.nextDown(schema.get("exclusiveMaximum").asDouble())
                : high;
        if (schema.has("default") && schema.get("default").isNumber() && dice.oneIn(4)) {
            return schema.get("default").asDouble();
        }
        boolean extreme = dice.oneIn(10);
        if (Double.isNaN(low)) {
            double size = Math.pow(10, dice.between(-2, extreme ? 300 : 3));
            return (dice.oneIn(3) ? -size : size) * dice.random().nextDouble();
        }
        if (Double.isNaN(high)) {
            double size = extreme
                    ? dice.pick(1e-320, 1e-300, 1e-30, 1e9, 1e30, 1e155, 1e300)
                    : Math.pow(10, dice.between(-2, 3));
            return low + size;
        }
        if (extreme) {
            return dice.oneIn(2) ? low : high;
        }
        return low > 0 && high / low > 100 && dice.oneIn(2)
                ? Math.max(
                        low,
                        Math.min(high, low * Math.pow(high / low, dice.random().nextDouble())))
                : low + (high - low) * dice.random().nextDouble();
    }

    private double cheap(String name, JsonNode schema) {
        double most = schema.get("maximum").asDouble();
        if (name.equals("rate")) {
            double rate = dice.oneIn(10) ? most : Math.pow(10, dice.between(-1.0, 1.3));
            fastest = Math.max(fastest, rate);
            return rate;
        }
        boolean picture = name.equals("width") || name.equals("height");
        if (picture && large && most > 10_000 && (largeSensor.isEmpty() || largeSensor.equals(sensor))) {
            largeSensor = sensor;
            return dice.oneIn(3) ? Math.rint(Math.pow(most, dice.between(0.7, 1.0))) : most;
        }
        return Math.max(least(schema), Math.min(most, dice.between(1, CHEAP.get(name))));
    }
}
