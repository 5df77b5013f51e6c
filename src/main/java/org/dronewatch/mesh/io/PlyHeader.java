package org.dronewatch.mesh.io;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * What the header of a PLY file says about what follows.
 *
 * @param order of the bytes of numbers; empty for text
 * @param elements the elements in the order of the file
 */
record PlyHeader(Optional<ByteOrder> order, List<Element> elements) {
    private static final int MOST_LINES = 10_000;
    private static final int LONGEST_LINE = 4096;

    /** Types of numbers; each has two names. */
    enum Type {
        INT8(1, "char", "int8"),
        UINT8(1, "uchar", "uint8"),
        INT16(2, "short", "int16"),
        UINT16(2, "ushort", "uint16"),
        INT32(4, "int", "int32"),
        UINT32(4, "uint", "uint32"),
        FLOAT32(4, "float", "float32"),
        FLOAT64(8, "double", "float64");

        final int bytes;
        private final List<String> names;

        Type(int bytes, String... names) {
            this.bytes = bytes;
            this.names = List.of(names);
        }

        static Type named(String name, String where) {
            for (Type type : values()) {
                if (type.names.contains(name.toLowerCase(Locale.ROOT))) {
                    return type;
                }
            }
            throw new InputException(where + "unknown type '" + PlainText.value(name) + "'");
        }
    }

    /**
     * One of the values of an element.
     *
     * @param count for a list, the type of the number that states its length
     */
    record Property(String name, Type type, Optional<Type> count) {}

    /** Things of one kind, such as vertices. */
    record Element(String name, long count, List<Property> properties) {
        /** The index of the property with a given name; -1 if there is none. */
        int indexOf(String property) {
            for (int i = 0; i < properties.size(); i++) {
                if (properties.get(i).name().equals(property)) {
                    return i;
                }
            }
            return -1;
        }
    }

    /** Reads a header to its end, and no byte more. */
    static PlyHeader read(String file, long size, InputStream in) throws IOException {
        Optional<ByteOrder> order = Optional.empty();
        boolean hasFormat = false;
        List<Element> elements = new ArrayList<>();
        for (int number = 1; number <= MOST_LINES; number++) {
            String where = file + ":" + number + ": ";
            String[] words = line(in, where).strip().split("\\s+");
            switch (words[0]) {
                case "ply", "comment", "obj_info", "" -> {
                    // The first line, or of no effect.
                }
                case "format" -> {
                    order = order(words, where);
                    hasFormat = true;
                }
                case "element" -> elements.add(element(words, size, where));
                case "property" -> {
                    if (elements.isEmpty()) {
                        throw new InputException(where + "a property before the first element");
                    }
                    elements.get(elements.size() - 1).properties().add(property(words, where));
                }
                case "end_header" -> {
                    if (!hasFormat) {
                        throw new InputException(where + "the header has no 'format'");
                    }
                    return new PlyHeader(order, elements);
                }
                default ->
                    throw new InputException(
                            where + "unknown keyword '" + PlainText.value(words[0]) + "' in the header of a PLY file");
            }
        }
        throw new InputException(file + ": its header has more than " + MOST_LINES + " lines");
    }

    private static String line(InputStream in, String where) throws IOException {
        StringBuilder line = new StringBuilder();
        for (int one = in.read(); one != '\n'; one = in.read()) {
            if (one < 0) {
                throw new InputException(where + "the header does not end");
            }
            line.append((char) one);
            if (line.length() > LONGEST_LINE) {
                throw new InputException(where + "a line of more than " + LONGEST_LINE + " characters: not a PLY file");
            }
        }
        return line.toString();
    }

    private static Optional<ByteOrder> order(String[] words, String where) {
        return switch (words.length > 1 ? words[1] : "") {
            case "ascii" -> Optional.empty();
            case "binary_little_endian" -> Optional.of(ByteOrder.LITTLE_ENDIAN);
            case "binary_big_endian" -> Optional.of(ByteOrder.BIG_ENDIAN);
            default ->
                throw new InputException(where
                        + "format must be ascii, binary_little_endian or binary_big_endian, not '"
                        + PlainText.value(words.length > 1 ? words[1] : "") + "'");
        };
    }

    private static Element element(String[] words, long size, String where) {
        if (words.length != 3 || !words[2].matches("\\d{1,18}")) {
            throw new InputException(where + "an element needs a name and a count");
        }
        long count = Long.parseLong(words[2]);
        if (count > size) {
            throw new InputException(
                    where + count + " elements '" + PlainText.value(words[1]) + "' in a file of " + size + " bytes");
        }
        return new Element(words[1], count, new ArrayList<>());
    }

    private static Property property(String[] words, String where) {
        if (words.length == 3) {
            return new Property(words[2], Type.named(words[1], where), Optional.empty());
        }
        if (words.length == 5 && words[1].equals("list")) {
            return new Property(words[4], Type.named(words[3], where), Optional.of(Type.named(words[2], where)));
        }
        throw new InputException(where + "a property needs a type and a name, or 'list', two types and a name");
    }
}
