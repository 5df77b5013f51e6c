package org.dronewatch.setting;

import java.lang.reflect.RecordComponent;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/** Switches the entries of a {@link Switchable} component of a settings record on and off. */
final class Switches {
    private final RecordComponent namesOfThoseOff;
    private final String name;

    private Switches(RecordComponent namesOfThoseOff, String name) {
        this.namesOfThoseOff = namesOfThoseOff;
        this.name = name;
    }

    /**
     * The switch that a path leads to.
     *
     * @param tree settings
     * @param path names from the tree's root, as in {@code sensors}, {@code gate}, {@code enabled}
     * @return empty when it leads to anything else
     */
    static Optional<Switches> at(Object tree, List<String> path) {
        if (!(tree instanceof Record settings)
                || path.size() != 3
                || !path.get(2).equals(Switchable.ENABLED)) {
            return Optional.empty();
        }
        SettingsForm form = SettingsForm.of(settings.getClass());
        return form.part(path.get(0))
                .filter(part -> part.isAnnotationPresent(Switchable.class))
                .filter(part -> ((Map<?, ?>) SettingsForm.get(settings, part)).containsKey(path.get(1)))
                .map(part -> new Switches(form.switchOf(part), path.get(1)));
    }

    boolean isEnabled(Record settings) {
        return !namesOf(settings).contains(name);
    }

    Record with(Record settings, boolean enabled) {
        Set<Object> names = new LinkedHashSet<>(namesOf(settings));
        if (enabled) {
            names.remove(name);
        } else {
            names.add(name);
        }
        return SettingsForm.with(settings, namesOfThoseOff.getName(), names);
    }

    private Set<?> namesOf(Record settings) {
        return (Set<?>) SettingsForm.get(settings, namesOfThoseOff);
    }
}
