package org.dronewatch.setting.file;

import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;

/** Writes nodes as readable YAML: a line for each setting, with short lists and mappings on one line. */
final class YamlText {
    /** Longest line into which a whole list or mapping is written, characters. */
    private static final int WIDTH = 100;

    /** Mappings of more values have a line for each. */
    private static final int MOST_IN_A_LINE = 3;

    /** From this depth on, a mapping may be written on one line; a drone or a sensor is less deep. */
    private static final int FLOW_DEPTH = 2;

    private static final String STEP = "  ";

    /** Texts that need no quotes anywhere. */
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z][A-Za-z0-9_./-]*(:[A-Za-z0-9_./-]+)*"
            + "|-?[0-9]+(\\.[0-9]+)?(E-?[0-9]+)?( [A-Za-z][A-Za-z0-9/]*)?");

    /** Words that some YAML readers interpret as null, true or false. */
    private static final Set<String> SPECIAL = Set.of("null", "yes", "no", "on", "off", "y", "n");

    private final StringBuilder text = new StringBuilder();

    private YamlText() {}

    /** A document, its last line ended by a line feed. */
    static String of(Node.Mapping document) {
        YamlText yaml = new YamlText();
        document.values().forEach((name, node) -> yaml.entry(scalar(name), node, 0));
        return yaml.text.toString();
    }

    private void entry(String name, Node node, int depth) {
        text.append(STEP.repeat(depth)).append(name).append(':');
        value(node, depth);
    }

    /** Writes what follows a name or a dash: on the same line if it fits, otherwise on separate lines. */
    private void value(Node node, int depth) {
        if (fitsInALine(node, depth)) {
            text.append(' ').append(flow(node)).append('\n');
        } else if (node instanceof Node.Mapping mapping) {
            text.append('\n');
            mapping.values().forEach((name, inner) -> entry(scalar(name), inner, depth + 1));
        } else if (node instanceof Node.Sequence sequence) {
            text.append('\n');
            for (Node item : sequence.items()) {
                text.append(STEP.repeat(depth + 1)).append('-');
                value(item, depth + 1);
            }
        }
    }

    private static boolean fitsInALine(Node node, int depth) {
        if (node instanceof Node.Mapping mapping) {
            boolean isSmall = depth >= FLOW_DEPTH && mapping.values().size() <= MOST_IN_A_LINE;
            return mapping.values().isEmpty() || isSmall && flow(node).length() <= WIDTH;
        }
        return !(node instanceof Node.Sequence sequence)
                || sequence.items().isEmpty()
                || flow(sequence).length() <= WIDTH && isOfScalars(sequence);
    }

    private static boolean isOfScalars(Node.Sequence sequence) {
        return sequence.items().stream()
                .allMatch(item ->
                        item instanceof Node.Scalar || item instanceof Node.Sequence inner && isOfScalars(inner));
    }

    private static String flow(Node node) {
        if (node instanceof Node.Mapping mapping) {
            return mapping.values().entrySet().stream()
                    .map(entry -> scalar(entry.getKey()) + ": " + flow(entry.getValue()))
                    .collect(Collectors.joining(", ", "{", "}"));
        }
        if (node instanceof Node.Sequence sequence) {
            return sequence.items().stream().map(YamlText::flow).collect(Collectors.joining(", ", "[", "]"));
        }
        return scalar(((Node.Scalar) node).text());
    }

    private static String scalar(String value) {
        return PLAIN.matcher(value).matches() && !SPECIAL.contains(value.toLowerCase(Locale.ROOT))
                ? value
                : quoted(value);
    }

    private static String quoted(String value) {
        StringBuilder quoted = new StringBuilder("\"");
        value.codePoints().forEach(c -> {
            if (c == '"' || c == '\\') {
                quoted.append('\\').appendCodePoint(c);
            } else if (c >= ' ' && c <= '~' || Character.isLetterOrDigit(c)) {
                quoted.appendCodePoint(c);
            } else {
                quoted.append(String.format(Locale.ROOT, "\\U%08X", c));
            }
        });
        return quoted.append('"').toString();
    }
}
