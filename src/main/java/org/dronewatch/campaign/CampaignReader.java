package org.dronewatch.campaign;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Pattern;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Mark;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;

/** Reads campaign files. */
public final class CampaignReader {
    private static final String VARY = "vary";
    private static final String TABLE = "table";
    private static final String SCENE = "scene";
    private static final Pattern PLACED = Pattern.compile("(vary|table|scene|sensitivity|until)[. ]");
    private static final String SUFFIX = ".csv";

    private CampaignReader() {}

    /**
     * Reads a file. The name of a table may replace the settings that vary, {@code vary: factors.csv}, or be listed
     * among them, {@code vary: {factors.csv, ...}}.
     *
     * @throws org.dronewatch.setting.InputException with a line for each error: file, line, column, setting, value and
     *     limit
     */
    public static CampaignSettings read(Path file) {
        Path directory = file.resolveSibling("").toAbsolutePath();
        return SettingsFile.read(
                withTable(SettingsFile.document(file)),
                CampaignSettings.class,
                Kinds.FOUND,
                directory,
                new FormerNames());
    }

    /**
     * Adds a location to a problem that came up while the cases were prepared. If the message begins with a setting of
     * the file, the new message begins with the location of that setting; otherwise the problem is returned as it is.
     *
     * @param file the file that was read
     */
    public static InputException placed(Path file, InputException problem) {
        String message = String.valueOf(problem.getMessage());
        if (!PLACED.matcher(message).lookingAt()) {
            return problem;
        }
        Node.Mapping document = withTable(SettingsFile.document(file));
        boolean isOther = message.startsWith(SCENE)
                && document.text(SCENE).filter(message::contains).isEmpty();
        return isOther ? problem : new InputException(document.markOf(message) + ": " + message, problem);
    }

    private static Node.Mapping withTable(Node.Mapping document) {
        Node vary = document.values().get(VARY);
        if (vary instanceof Node.Scalar name && isTable(name.text())) {
            return withTable(document, name, null);
        }
        if (vary instanceof Node.Mapping factors) {
            for (Map.Entry<String, Node> factor : factors.values().entrySet()) {
                boolean isName = factor.getValue() instanceof Node.Scalar value
                        && value.text().isEmpty();
                if (isName && isTable(factor.getKey())) {
                    Mark mark = factors.keys().get(factor.getKey());
                    Map<String, Node> others = new LinkedHashMap<>(factors.values());
                    others.remove(factor.getKey());
                    return withTable(
                            document,
                            new Node.Scalar(factor.getKey(), mark),
                            new Node.Mapping(others, factors.keys(), factors.mark(), factors.size()));
                }
            }
        }
        return document;
    }

    private static boolean isTable(String name) {
        return name.toLowerCase(Locale.ROOT).endsWith(SUFFIX);
    }

    private static Node.Mapping withTable(Node.Mapping document, Node.Scalar table, Node.Mapping vary) {
        Map<String, Node> values = new LinkedHashMap<>(document.values());
        Map<String, Mark> keys = new LinkedHashMap<>(document.keys());
        values.remove(VARY);
        if (vary != null) {
            values.put(VARY, vary);
        }
        if (values.putIfAbsent(TABLE, table) == null) {
            keys.put(TABLE, table.mark());
        }
        return new Node.Mapping(values, keys, document.mark(), document.size());
    }
}
