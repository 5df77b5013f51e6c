package org.dronewatch.scenario;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.file.Mark;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;

/**
 * A condition such as night or rain: a name for changes to a scene's settings.
 *
 * @param name name of the condition
 * @param changes one or more, in the order of the file
 */
public record SceneCondition(String name, List<Change> changes) {
    /** Maximum number of conditions in a file. */
    public static final int MOST = 12;

    /** The name of the scene without a condition, which no condition may have. */
    public static final String AS_IT_IS = "as it is";

    /** The longest name. */
    private static final int LONGEST_NAME = 40;

    /**
     * A change of one setting to another value.
     *
     * @param path path of the setting, as for {@code --set}
     * @param value the new value, as text
     * @param mark location of the change in the file
     */
    public record Change(String path, String value, Mark mark) {}

    /** Copies the list: later changes by the caller have no effect. */
    public SceneCondition {
        changes = List.copyOf(changes);
    }

    /**
     * The conditions of a YAML file: under each name, values by the paths of settings, which may be written in full or
     * nested.
     *
     * @throws InputException in one line, with file, line and column, when the file is not of this form; whether a
     *     scene has the settings is not checked
     */
    public static List<SceneCondition> read(Path file) {
        Node.Mapping document = SettingsFile.document(file);
        List<SceneCondition> conditions = new ArrayList<>();
        for (Map.Entry<String, Node> entry : document.values().entrySet()) {
            Mark mark = document.keys().get(entry.getKey());
            String name = entry.getKey();
            if (name.isBlank() || name.length() > LONGEST_NAME) {
                throw new InputException(mark + ": a condition's name must have 1 to " + LONGEST_NAME + " characters: "
                        + PlainText.value(name));
            }
            if (name.strip().equalsIgnoreCase(AS_IT_IS)) {
                throw new InputException(mark + ": " + PlainText.value(name)
                        + ": in tables, this is the name of the scene without a condition");
            }
            List<Change> changes = new ArrayList<>();
            add(changes, "", entry.getValue());
            if (changes.isEmpty()) {
                throw new InputException(mark + ": " + PlainText.value(name) + " changes no setting");
            }
            conditions.add(new SceneCondition(name, changes));
        }
        if (conditions.isEmpty() || conditions.size() > MOST) {
            throw new InputException(
                    PlainText.value(file) + ": has " + conditions.size() + " conditions but must have 1 to " + MOST);
        }
        return conditions;
    }

    private static void add(List<Change> changes, String path, Node node) {
        if (node instanceof Node.Mapping mapping) {
            mapping.values().forEach((name, inner) -> add(changes, path.isEmpty() ? name : path + "." + name, inner));
        } else if (node instanceof Node.Scalar scalar && !path.isEmpty()) {
            changes.add(new Change(path, scalar.text(), scalar.mark()));
        } else {
            throw new InputException(node.mark() + ": "
                    + (path.isEmpty()
                            ? "must give settings by their paths, as in 'world.rain: 10 mm/h'"
                            : PlainText.value(path) + ": must be a single value, or named values"));
        }
    }
}
