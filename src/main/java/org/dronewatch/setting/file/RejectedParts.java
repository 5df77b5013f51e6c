package org.dronewatch.setting.file;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.setting.SettingsForm;

/** The parts of a record that it rejects although each is within its own limits. */
final class RejectedParts {
    private final Problems problems;
    private final SettingsForm form;
    private final Node.Mapping mapping;
    private final Map<String, Object> values;
    private final Map<String, Object> needed;
    private final String path;

    /**
     * @param values those parts of the mapping that could be read, including all required parts
     * @param path path of the record
     */
    RejectedParts(Problems problems, SettingsForm form, Node.Mapping mapping, Map<String, Object> values, String path) {
        this.problems = problems;
        this.form = form;
        this.mapping = mapping;
        this.values = values;
        this.needed = new LinkedHashMap<>(values);
        this.needed.keySet().retainAll(form.required());
        this.path = path;
    }

    /**
     * Reports why the record is rejected with its required parts alone; if it is not, reports each part that is
     * rejected when only the required parts are added to it. Returns whether anything was reported.
     */
    boolean report() {
        Optional<String> whatIsRequired = rejection(needed);
        if (whatIsRequired.isPresent()) {
            problems.add(mapping.markOf(whatIsRequired.get()), path, whatIsRequired.get());
            return true;
        }
        Map<String, String> rejected = new LinkedHashMap<>();
        values.forEach((name, value) -> alone(name, value).ifPresent(why -> rejected.put(name, why)));
        int before = problems.count();
        rejected.forEach((name, why) -> {
            if (isStillRejected(name, rejected)) {
                add(name, why);
            }
        });
        return problems.count() > before;
    }

    private Optional<String> alone(String name, Object value) {
        Map<String, Object> one = new LinkedHashMap<>(needed);
        one.put(name, value);
        return rejection(one);
    }

    /**
     * Whether a part is still rejected, for the same reason, together with all parts that are not rejected: it may need
     * one of them.
     */
    private boolean isStillRejected(String name, Map<String, String> rejected) {
        String why = rejected.get(name);
        if (unread().stream().anyMatch(why::contains)) {
            return false;
        }
        Map<String, Object> others = new LinkedHashMap<>(values);
        others.keySet().removeIf(other -> rejected.containsKey(other) && !other.equals(name));
        return rejection(others).filter(why::equals).isPresent();
    }

    /** The parts that could not be read, as has been reported already. */
    private Set<String> unread() {
        Set<String> names = new LinkedHashSet<>(mapping.values().keySet());
        names.removeAll(values.keySet());
        return names;
    }

    private Optional<String> rejection(Map<String, Object> parts) {
        try {
            form.create(parts);
            return Optional.empty();
        } catch (IllegalArgumentException e) {
            return Optional.of(e.getMessage());
        }
    }

    private void add(String name, String why) {
        String inner = why.replaceFirst("^\\Q" + name + "\\E[.]", "");
        Mark at = mapping.values().getOrDefault(name, mapping).markOf(inner);
        problems.add(at, path.isEmpty() ? name : path + "." + name, inner);
    }
}
