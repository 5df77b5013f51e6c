package org.dronewatch.setting.file;

import java.util.Collections;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** A node of a document with its location. Immutable; an alias makes one node appear at two locations. */
public sealed interface Node {
    /** The location of the node. */
    Mark mark();

    /**
     * The location of the value that a message is about, if this node holds values by name; otherwise the location of
     * this node. The message begins with the path of the value, as in {@code alert.rule.count 5 must be}.
     *
     * @param text the message
     */
    default Mark markOf(String text) {
        return mark();
    }

    /** The number of nodes of this subtree; a node that appears twice counts twice. At most {@link Long#MAX_VALUE}. */
    long size();

    /**
     * A single value.
     *
     * @param text the value as written; empty if there is none
     */
    record Scalar(String text, Mark mark) implements Node {
        @Override
        public long size() {
            return 1;
        }
    }

    /**
     * A value that was put into a document by code.
     *
     * @param value the value, of the type required at its location
     */
    record Ready(Object value, Mark mark) implements Node {
        @Override
        public long size() {
            return 1;
        }
    }

    /**
     * A list.
     *
     * @param size number of nodes, including this one
     */
    record Sequence(List<Node> items, Mark mark, long size) implements Node {
        static Sequence of(List<Node> items, Mark mark) {
            return new Sequence(List.copyOf(items), mark, sizeOf(items));
        }
    }

    /**
     * Values by name, in their order.
     *
     * @param keys the location of each name
     * @param size number of nodes, including this one
     */
    record Mapping(Map<String, Node> values, Map<String, Mark> keys, Mark mark, long size) implements Node {
        static Mapping of(Map<String, Node> values, Map<String, Mark> keys, Mark mark) {
            return new Mapping(
                    Collections.unmodifiableMap(new LinkedHashMap<>(values)),
                    Map.copyOf(keys),
                    mark,
                    sizeOf(values.values()));
        }

        private boolean isOfAnotherKindThan(Mapping other) {
            Optional<String> kind = text(KindChooser.KIND);
            return kind.isPresent() && !kind.equals(other.text(KindChooser.KIND));
        }

        /**
         * The values of this mapping, replaced by or completed with those of another. Where both hold a mapping under
         * the same name, the two are merged instead, unless that of the other mapping names another kind.
         */
        public Mapping overlaidWith(Mapping over) {
            Map<String, Node> all = new LinkedHashMap<>(values);
            Map<String, Mark> places = new LinkedHashMap<>(keys);
            over.values.forEach((name, value) -> {
                all.merge(
                        name,
                        value,
                        (mine, theirs) -> mine instanceof Mapping below
                                        && theirs instanceof Mapping above
                                        && !above.isOfAnotherKindThan(below)
                                ? below.overlaidWith(above)
                                : theirs);
                places.put(name, over.keys.get(name));
            });
            return of(all, places, over.mark);
        }

        /**
         * A mapping of values that come from code rather than from a file.
         *
         * @param name stands for the name of a file in the locations of the values
         */
        public static Mapping ofReady(String name, Map<String, ?> values) {
            Mark mark = new Mark(name, 1, 1);
            Map<String, Node> nodes = new LinkedHashMap<>();
            Map<String, Mark> places = new LinkedHashMap<>();
            values.forEach((part, value) -> {
                nodes.put(part, new Ready(value, mark));
                places.put(part, mark);
            });
            return of(nodes, places, mark);
        }

        /**
         * A mapping of nodes that come from code.
         *
         * @param name stands for the name of a file in the locations of the nodes' names
         */
        public static Mapping ofNodes(String name, Map<String, ? extends Node> nodes) {
            Mark mark = new Mark(name, 1, 1);
            Map<String, Mark> places = new LinkedHashMap<>();
            nodes.keySet().forEach(part -> places.put(part, mark));
            return of(new LinkedHashMap<>(nodes), places, mark);
        }

        /** The mapping {@code use: NAME} alone. */
        public static Mapping ofUse(String name) {
            return ofNodes(name, Map.of(KindChooser.USE, new Scalar(name, new Mark(name, 1, 1))));
        }

        /** The mapping {@code kind: NAME} alone. */
        public static Mapping ofKind(String name) {
            Mark mark = new Mark(name, 1, 1);
            return of(Map.of(KindChooser.KIND, new Scalar(name, mark)), Map.of(KindChooser.KIND, mark), mark);
        }

        /**
         * The location of the value with whose path a message begins, as in {@code alert.rule.count 5 must be}; for a
         * value that the file omits, the location of the mapping that should hold it.
         */
        @Override
        public Mark markOf(String text) {
            Node here = this;
            String rest = text;
            while (here instanceof Mapping mapping) {
                String left = rest;
                Optional<String> name = mapping.values.keySet().stream()
                        .filter(key -> left.startsWith(key)
                                && left.substring(key.length()).matches("([.: ='].*)?"))
                        .max(Comparator.comparingInt(String::length));
                if (name.isEmpty()) {
                    break;
                }
                here = mapping.values.get(name.get());
                rest = rest.substring(name.get().length()).replaceFirst("^[.]", "");
            }
            if (here instanceof Sequence list && rest.matches("\\d{1,6}\\b.*")) {
                int index = Integer.parseInt(rest.replaceFirst("\\D.*", ""));
                String inner = rest.replaceFirst("^\\d+[.]?", "");
                if (index < list.items.size()) {
                    Node item = list.items.get(index);
                    return item instanceof Mapping mapping ? mapping.markOf(inner) : item.mark();
                }
            }
            return here.mark();
        }

        /** The text of a single value; empty when there is none with this name. */
        public Optional<String> text(String name) {
            return values.get(name) instanceof Scalar scalar ? Optional.of(scalar.text()) : Optional.empty();
        }

        /** The mapping with this name; empty when there is none. */
        public Optional<Mapping> mapping(String name) {
            return values.get(name) instanceof Mapping inner ? Optional.of(inner) : Optional.empty();
        }

        /** This mapping without some of its values. */
        public Mapping without(List<String> names) {
            Map<String, Node> rest = new LinkedHashMap<>(values);
            names.forEach(rest::remove);
            return of(rest, keys, mark);
        }
    }

    private static long sizeOf(Iterable<Node> parts) {
        long sum = 1;
        for (Node part : parts) {
            sum = part.size() > Long.MAX_VALUE - sum ? Long.MAX_VALUE : sum + part.size();
        }
        return sum;
    }
}
