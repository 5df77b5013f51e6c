package org.dronewatch.setting.file;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.KindRegistry;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.Spelling;

/** Collects the errors in a file, so that all are reported together. */
final class Problems {
    private static final int SHOWN = 50;
    private static final int LONGEST = 400;

    private final List<Problem> found = new ArrayList<>();

    private record Problem(Mark mark, String text) {}

    /**
     * Adds an error.
     *
     * @param mark its location
     * @param field path of the setting, empty for the whole document
     */
    void add(Mark mark, String field, String message) {
        // Messages about a number begin with its name, which is also its path at the top level of a file.
        boolean isNamed = field.isEmpty() || message.startsWith(field + " ");
        String line = PlainText.line(mark + ": " + (isNamed ? "" : field + ": ") + message);
        found.add(new Problem(mark, PlainText.beginning(line, LONGEST)));
    }

    /** Adds that a name is not one of those allowed there. */
    void unknown(Mark mark, String field, String what, String name, Collection<String> known) {
        unknown(mark, field, what, name, known, Spelling.didYouMean(name, known));
    }

    /** Adds that there is no kind with this name, and which one may be meant. */
    void unknownKind(Mark mark, String field, String name, Collection<String> known, Class<?> type) {
        KindRegistry kinds = KindRegistry.found();
        String meant = kinds.meant(type, name, known).map(Spelling::question).orElse("");
        String jar = meant.isEmpty() ? kinds.otherJar(type) : "";
        add(mark, field, unknown(KindChooser.KIND, name, known, meant) + jar);
    }

    /** Adds that a record has no part with this name. */
    void unknownSetting(Mark mark, String field, String name, SettingsForm form, List<String> others) {
        List<String> known = new ArrayList<>(form.names());
        known.addAll(others);
        unknown(mark, field, "setting", name, known, form.didYouMean(name, others));
    }

    private void unknown(
            Mark mark, String field, String what, String name, Collection<String> known, String suggestion) {
        add(mark, field, unknown(what, name, known, suggestion));
    }

    private static String unknown(String what, String name, Collection<String> known, String suggestion) {
        return "unknown " + what + " '" + name + "'" + suggestion + " (" + String.join(", ", known) + ")";
    }

    int count() {
        return found.size();
    }

    /**
     * Throws if there are any problems.
     *
     * @throws InputException with a line for each, in the order of the file
     */
    void throwIfAny() {
        if (!found.isEmpty()) {
            List<String> shown = new ArrayList<>();
            found.stream()
                    .sorted(Comparator.comparing(Problem::mark))
                    .limit(SHOWN)
                    .forEach(problem -> shown.add(problem.text()));
            if (found.size() > SHOWN) {
                shown.add("... and " + (found.size() - SHOWN) + " more");
            }
            throw new InputException(shown);
        }
    }
}
