package org.dronewatch.setting.file;

import java.lang.reflect.RecordComponent;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.setting.AsNumbers;
import org.dronewatch.setting.SettingsForm;

/**
 * Reads values that are written in a form other than their own; see {@link Kinds#with(Class, Class,
 * java.util.function.Function)}.
 */
final class OtherForms {
    private final Kinds kinds;
    private final Problems problems;

    OtherForms(Kinds kinds, Problems problems) {
        this.kinds = kinds;
        this.problems = problems;
    }

    /**
     * The form in which a mapping represents a record of this type: the one that knows most of the mapping's names, or
     * the first if none of them is a name of the record; empty for the record's own form.
     */
    Optional<Kinds.OtherForm> of(Class<?> type, Node.Mapping mapping) {
        List<Kinds.OtherForm> forms = kinds.otherForms(type);
        if (forms.isEmpty()) {
            return Optional.empty();
        }
        Set<String> foreign = new HashSet<>(mapping.values().keySet());
        boolean isOwn = foreign.removeAll(SettingsForm.of(type).names()) || foreign.isEmpty();
        Kinds.OtherForm best = isOwn ? null : forms.get(0);
        long most = 0;
        for (Kinds.OtherForm form : forms) {
            long known = SettingsForm.of(form.parts()).names().stream()
                    .filter(foreign::contains)
                    .count();
            if (known > most) {
                most = known;
                best = form;
            }
        }
        return Optional.ofNullable(best);
    }

    /** The value that a form represents; empty if there is none, in which case a problem here or elsewhere says why. */
    Optional<Object> value(Kinds.OtherForm form, Object written, Node node, String path) {
        try {
            return form.value().apply((Record) written).map(Object.class::cast);
        } catch (IllegalArgumentException e) {
            problems.add(node.mark(), path, e.getMessage());
            return Optional.empty();
        }
    }

    /** Whether a part is written in another form although it must not be; adds a problem if so. */
    boolean isRefused(RecordComponent part, Node node, String path) {
        boolean refused = part.isAnnotationPresent(AsNumbers.class)
                && node instanceof Node.Mapping mapping
                && of(part.getType(), mapping).isPresent();
        if (refused) {
            problems.add(
                    node.mark(),
                    path,
                    "must be numbers: "
                            + String.join(", ", SettingsForm.of(part.getType()).names()));
        }
        return refused;
    }
}
