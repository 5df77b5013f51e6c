package org.dronewatch.setting.file;

import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.dronewatch.setting.SettingsForm;

/**
 * Replaces the name of a system by its parts: {@code gate: {use: SYSTEM, position: ...}} becomes {@code gate-radar} and
 * the like, each with those of the settings written for the system that apply to this part.
 */
final class NamedGroups {
    private final Kinds kinds;
    private final Problems problems;

    NamedGroups(Kinds kinds, Problems problems) {
        this.kinds = kinds;
        this.problems = problems;
    }

    /** The entries of a component, with systems replaced by their parts. */
    Node expanded(RecordComponent part, Node node, String field) {
        return node instanceof Node.Mapping all
                        && part.getGenericType() instanceof ParameterizedType type
                        && type.getRawType() == Map.class
                ? expanded(rawType(type.getActualTypeArguments()[1]), all, field)
                : node;
    }

    private static Class<?> rawType(Type type) {
        return (Class<?>) (type instanceof ParameterizedType parameterized ? parameterized.getRawType() : type);
    }

    /**
     * A mapping without names of systems.
     *
     * @param type type of its values
     * @param field path of the mapping
     */
    private Node.Mapping expanded(Class<?> type, Node.Mapping all, String field) {
        Optional<Kinds.NamedSettings> named = kinds.named(type);
        if (named.isEmpty()) {
            return all;
        }
        Map<String, Node> values = new LinkedHashMap<>();
        Map<String, Mark> keys = new LinkedHashMap<>(all.keys());
        all.values().forEach((name, node) -> {
            Map<String, Node.Mapping> parts = node instanceof Node.Mapping written
                    ? written.text(KindChooser.USE).map(named.get()::partsOf).orElse(Map.of())
                    : Map.of();
            if (parts.isEmpty()) {
                put(values, name, node, field);
                return;
            }
            Node.Mapping written = (Node.Mapping) node;
            parts.forEach((part, settings) -> {
                String whole = name + "-" + part;
                keys.put(whole, all.keys().get(name));
                put(
                        values,
                        whole,
                        named(settings, parts, name).overlaidWith(thatApplies(written, type, settings, parts)),
                        field);
            });
        });
        return Node.Mapping.of(values, keys, all.mark());
    }

    private void put(Map<String, Node> values, String name, Node node, String field) {
        if (values.putIfAbsent(name, node) != null) {
            problems.add(node.mark(), field + "." + name, "is defined twice: once as a part of a system");
        }
    }

    /**
     * What is written for a system, without the settings that other parts of the system have but this part does not.
     */
    private Node.Mapping thatApplies(
            Node.Mapping written, Class<?> type, Node.Mapping part, Map<String, Node.Mapping> parts) {
        List<String> left = new ArrayList<>(List.of(KindChooser.USE));
        for (String name : written.values().keySet()) {
            boolean othersHave = parts.values().stream().anyMatch(other -> has(type, other, name));
            if (othersHave && !has(type, part, name)) {
                left.add(name);
            }
        }
        return written.without(left);
    }

    private boolean has(Class<?> type, Node.Mapping part, String name) {
        return part.text(KindChooser.USE)
                .flatMap(kinds.named(type).orElseThrow()::find)
                .flatMap(entry -> entry.text(KindChooser.KIND))
                .map(kind -> kinds.of(type).get(kind))
                .map(form -> SettingsForm.of(form).names().contains(name))
                .orElse(false);
    }

    /** A part in which other parts are referred to by their names in this system. */
    private static Node.Mapping named(Node.Mapping part, Map<String, Node.Mapping> parts, String system) {
        Map<String, Node> values = new LinkedHashMap<>();
        part.values().forEach((name, node) -> values.put(name, named(node, parts, system)));
        return Node.Mapping.of(values, part.keys(), part.mark());
    }

    private static Node named(Node node, Map<String, Node.Mapping> parts, String system) {
        if (node instanceof Node.Mapping mapping) {
            return named(mapping, parts, system);
        }
        if (node instanceof Node.Sequence list) {
            return list.items().stream()
                    .map(item -> item instanceof Node.Scalar scalar && parts.containsKey(scalar.text())
                            ? new Node.Scalar(system + "-" + scalar.text(), scalar.mark())
                            : item)
                    .collect(Collectors.collectingAndThen(
                            Collectors.toList(),
                            items -> Node.Sequence.of(Collections.unmodifiableList(items), list.mark())));
        }
        return node;
    }
}
