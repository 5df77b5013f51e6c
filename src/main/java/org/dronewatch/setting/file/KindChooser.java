package org.dronewatch.setting.file;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.dronewatch.setting.SettingsForm;

/**
 * Finds out which of several kinds of settings a mapping means: by its kind, by the ready settings that it uses, or by
 * its parts.
 */
final class KindChooser {
    /** The name under which a kind is written. */
    static final String KIND = "kind";

    /** The name under which a file refers to ready settings. */
    static final String USE = "use";

    private final Kinds kinds;
    private final Problems problems;

    KindChooser(Kinds kinds, Problems problems) {
        this.kinds = kinds;
        this.problems = problems;
    }

    /**
     * The choice.
     *
     * @param form form of the kind
     * @param parts the settings that the file states, completed with those that were taken from ready settings
     */
    record Chosen(SettingsForm form, Node.Mapping parts) {}

    /** The kind that a mapping means; empty when it is not clear, and a problem says why. */
    Optional<Chosen> choose(Class<?> type, Node.Mapping written, String path) {
        Optional<Node.Mapping> whole = withReadySettings(type, written, path);
        if (whole.isEmpty()) {
            return Optional.empty();
        }
        Node.Mapping mapping = whole.get();
        Map<String, Class<?>> choices = kinds.of(type);
        Node given = mapping.values().get(KIND);
        if (given == null) {
            Optional<Class<?>> meant = meant(choices, mapping.values().keySet());
            if (meant.isEmpty()) {
                String all = String.join(", ", choices.keySet());
                problems.add(mapping.mark(), path, "needs a '" + KIND + "': one of " + all);
            }
            return meant.map(kind -> new Chosen(SettingsForm.of(kind), mapping));
        }
        String kind = given instanceof Node.Scalar scalar ? scalar.text() : "";
        if (!choices.containsKey(kind)) {
            problems.unknownKind(given.mark(), path + "." + KIND, kind, choices.keySet(), type);
            return Optional.empty();
        }
        return Optional.of(new Chosen(SettingsForm.of(choices.get(kind)), mapping.without(List.of(KIND))));
    }

    /** The entries that override the catalogue settings it starts from, if any. */
    Optional<Node.Mapping> withReadySettings(Class<?> type, Node.Mapping written, String path) {
        Optional<Kinds.NamedSettings> named = kinds.named(type);
        if (named.isEmpty() || !(written.values().get(USE) instanceof Node.Scalar name)) {
            return Optional.of(written);
        }
        Optional<Node.Mapping> found = named.get().find(name.text());
        if (found.isEmpty()) {
            problems.unknown(
                    name.mark(),
                    path + "." + USE,
                    "name",
                    name.text(),
                    named.get().names());
            return Optional.empty();
        }
        Optional<String> kind = written.text(KIND);
        Optional<String> its = found.get().text(KIND);
        if (kind.isPresent() && !kind.equals(its)) {
            problems.add(
                    written.values().get(KIND).mark(),
                    path + "." + KIND,
                    "is '" + kind.get() + "', but '" + name.text() + "' is of kind '" + its.orElse("") + "'");
            return Optional.empty();
        }
        return Optional.of(found.get().overlaidWith(written.without(List.of(USE))));
    }

    /** The only kind that has all these components, or else the only one of those that requires no others. */
    private static Optional<Class<?>> meant(Map<String, Class<?>> choices, Set<String> names) {
        List<Class<?>> fitting = new ArrayList<>(choices.values());
        fitting.removeIf(choice -> !SettingsForm.of(choice).names().containsAll(current(choice, names)));
        if (fitting.size() > 1) {
            fitting.removeIf(choice ->
                    !current(choice, names).containsAll(SettingsForm.of(choice).required()));
        }
        return fitting.size() == 1 ? Optional.of(fitting.get(0)) : Optional.empty();
    }

    private static Set<String> current(Class<?> choice, Set<String> names) {
        SettingsForm form = SettingsForm.of(choice);
        return names.stream().map(form::currentName).collect(Collectors.toSet());
    }
}
