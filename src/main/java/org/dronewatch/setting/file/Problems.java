package org.dronewatch.setting.file;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.Spelling;

/** Collects what is wrong with a file, so that a person learns all of it at once. */
final class Problems {
    private static final int SHOWN = 50;
    private static final int LONGEST = 400;

    private final List<String> found = new ArrayList<>();

    /**
     * Adds one.
     *
     * @param mark where it stands
     * @param field path of the setting, empty for the whole document
     */
    void add(Mark mark, String field, String message) {
        String line = mark + ": " + (field.isEmpty() ? "" : field + ": ") + message;
        found.add(line.length() <= LONGEST ? line : line.substring(0, LONGEST) + "...");
    }

    /** Adds that a name is not one of those that may stand there. */
    void unknown(Mark mark, String field, String what, String name, Collection<String> known) {
        List<String> nearest = Spelling.nearest(name, known, 1);
        String meant = nearest.isEmpty() ? "" : "; did you mean '" + nearest.get(0) + "'?";
        add(mark, field, "unknown " + what + " '" + name + "'" + meant + " (" + String.join(", ", known) + ")");
    }

    boolean isEmpty() {
        return found.isEmpty();
    }

    int count() {
        return found.size();
    }

    /**
     * Ends it if there are any.
     *
     * @throws InputException with a line for each
     */
    void throwIfAny() {
        if (!found.isEmpty()) {
            List<String> shown = new ArrayList<>(found.subList(0, Math.min(SHOWN, found.size())));
            if (found.size() > SHOWN) {
                shown.add("... and " + (found.size() - SHOWN) + " more");
            }
            throw new InputException(shown);
        }
    }
}
