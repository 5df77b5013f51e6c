package org.dronewatch.setting.file;

import java.util.Map;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.SettingsForm;

/**
 * Gives settings that are written under a former name their current name; see {@link org.dronewatch.setting.Formerly}.
 */
final class FormerNameReader {
    private final FormerNames used;
    private final Problems problems;

    /**
     * A reader of names.
     *
     * @param used receives the former names that are found
     * @param problems receives the settings that are given by two of their names
     */
    FormerNameReader(FormerNames used, Problems problems) {
        this.used = used;
        this.problems = problems;
    }

    /** The entries written for a record, by current names. */
    Node.Mapping read(SettingsForm form, Node.Mapping written, String path) {
        if (written.values().keySet().stream().noneMatch(form.renamed()::containsKey)) {
            return written;
        }
        Node.Mapping below = Node.Mapping.of(Map.of(), Map.of(), written.mark());
        Node.Mapping above = below;
        for (String name : written.values().keySet()) {
            Node.Mapping one = one(form, written, name);
            String current = form.currentName(name);
            Mark here = written.keys().get(name);
            if (!current.equals(name)) {
                used.add(form, name, here.toString());
            }
            // What a file states takes precedence over the catalogue entry that it starts from, under either name.
            boolean isAbove = here.file().equals(written.mark().file());
            Mark other = (isAbove ? above : below).keys().get(current);
            if (other != null) {
                problems.add(here, path, twice(form, name, current, other));
            }
            above = isAbove ? above.overlaidWith(one) : above;
            below = isAbove ? below : below.overlaidWith(one);
        }
        return below.overlaidWith(above);
    }

    private static Node.Mapping one(SettingsForm form, Node.Mapping written, String name) {
        String current = form.currentName(name);
        return Node.Mapping.of(
                Map.of(current, written.values().get(name)),
                Map.of(current, written.keys().get(name)),
                written.mark());
    }

    private static String twice(SettingsForm form, String name, String current, Mark other) {
        String what = form.renamed().containsKey(name)
                ? "'" + name + "' is a former name of '" + current + "'"
                : "'" + name + "' is also written under a former name";
        return what + "; it is already given at " + other;
    }
}
