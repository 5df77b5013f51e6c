package org.dronewatch.fuzz;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Locale;

/** Mistakes in a scene file, made line by line with regard to keys, values and indentation. */
final class YamlMutation {
    private static final List<String> TAGS = List.of(
            "!!str",
            "!!int",
            "!!binary",
            "!!java.lang.Runtime",
            "!!javax.script.ScriptEngineManager",
            "!local",
            "!<tag:x>",
            "!!set",
            "!!timestamp",
            "!!null");

    private final List<String> lines;
    private final Dice dice;

    YamlMutation(String scene, Dice dice) {
        this.lines = new ArrayList<>(
                scene.lines().filter(line -> !line.startsWith("#")).toList());
        this.dice = dice;
    }

    String mutated() {
        for (int i = dice.oneIn(3) ? dice.between(2, 4) : 1; i > 0; i--) {
            mutate(dice.below(lines.size()));
        }
        String end = dice.oneIn(15) ? "\r\n" : "\n";
        String text = String.join(end, lines) + end;
        return switch (dice.below(40)) {
            case 0 -> "\uFEFF" + text;
            case 1 -> "%YAML 9.9\n---\n" + text;
            case 2 -> text + "---\n" + text;
            case 3 -> text.replace("  ", "\t");
            case 4 -> "";
            default -> text;
        };
    }

    private void mutate(int at) {
        String line = lines.get(at);
        int colon = line.indexOf(": ");
        String key =
                line.endsWith(":") ? line.substring(0, line.length() - 1) : colon < 0 ? line : line.substring(0, colon);
        switch (dice.below(14)) {
            case 0 -> lines.set(at, misspelt(key) + line.substring(key.length()));
            case 1, 2, 3 -> lines.set(at, inFlow(line, key));
            case 4 -> lines.add(at, line);
            case 5 ->
                lines.subList(at, Math.min(lines.size(), at + dice.between(1, 8)))
                        .clear();
            case 6 -> lines.add(dice.below(lines.size()), line);
            case 7 -> lines.set(at, key + ": " + nested(dice.pick(3, 20, 31, 33, 60, 1000, 5000)));
            case 8 -> bomb(at, key);
            case 9 ->
                lines.set(
                        at,
                        key + ": " + dice.pick(TAGS) + " " + line.substring(Math.min(line.length(), key.length() + 1)));
            case 10 -> lines.set(at, key + ": " + huge());
            case 11 -> lines.set(at, indent(line) + quoted(NastyValues.name(dice)) + line.substring(key.length()));
            case 12 -> lines.set(at, key + ": " + quoted(NastyValues.name(dice)));
            default -> lines.set(at, " ".repeat(dice.below(8)) + line.strip());
        }
        if (lines.isEmpty()) {
            lines.add("");
        }
    }

    /** Another value of the line's key, or of one of the keys in its braces. */
    private String inFlow(String line, String key) {
        String value = value();
        if (!line.contains("{")) {
            return key + ": " + value;
        }
        String[] parts = line.split("(?<=[{,])|(?=[},])");
        int chosen = dice.below(parts.length);
        StringBuilder changed = new StringBuilder();
        for (int i = 0; i < parts.length; i++) {
            int colon = parts[i].indexOf(": ");
            changed.append(i == chosen && colon > 0 ? parts[i].substring(0, colon + 2) + value : parts[i]);
        }
        return changed.toString();
    }

    private String value() {
        String value = NastyValues.any(dice);
        return dice.oneIn(3) ? quoted(value) : value;
    }

    private String misspelt(String key) {
        int at = dice.below(key.length() + 1);
        return switch (dice.below(4)) {
            case 0 -> key.substring(0, at) + dice.pick("x", "E", " ", "-", "\u0435", "") + key.substring(at);
            case 1 -> key.substring(0, Math.max(0, key.length() - 1));
            case 2 -> key.toUpperCase(Locale.ROOT);
            default -> key + key.strip();
        };
    }

    private String nested(int depth) {
        return dice.oneIn(2) ? "[".repeat(depth) + "]".repeat(depth) : "{a: ".repeat(depth) + "1" + "}".repeat(depth);
    }

    /**
     * Aliases of aliases, which would take the memory of all machines if they were written out; or an alias of itself.
     */
    private void bomb(int at, String key) {
        if (dice.oneIn(3)) {
            lines.set(at, key + ": " + dice.pick("&a [*a]", "*unknown", "&a {<<: *a}", "&a 1", "{<<: {x: 1}}"));
            return;
        }
        int width = dice.between(2, 12);
        List<String> bomb = new ArrayList<>();
        bomb.add("b0: &b0 [x, x, x]");
        for (int level = 1; level < dice.between(4, 30); level++) {
            String alias = "*b" + (level - 1);
            bomb.add("b" + level + ": &b" + level + " [" + String.join(", ", Collections.nCopies(width, alias)) + "]");
        }
        lines.addAll(0, bomb);
    }

    private String huge() {
        String letter = dice.pick("Q", "7", "\u00E9");
        int size = dice.pick(250, 1000, 19_000, 30_000, 300_000);
        return switch (dice.below(3)) {
            case 0 -> letter.repeat(size);
            case 1 -> quoted(letter.repeat(size));
            default ->
                "|\n" + "          " + letter.repeat(100) + ("\n          " + letter.repeat(100)).repeat(size / 100);
        };
    }

    private static String indent(String line) {
        return line.substring(0, line.length() - line.stripLeading().length());
    }

    /** In double quotes, with escapes, in which any text can be written. */
    static String quoted(String text) {
        StringBuilder quoted = new StringBuilder("\"");
        text.chars().forEach(c -> {
            boolean plain = c >= ' ' && c < 127 && c != '"' && c != '\\';
            quoted.append(plain ? String.valueOf((char) c) : String.format("\\u%04X", c));
        });
        return quoted.append('"').toString();
    }
}
