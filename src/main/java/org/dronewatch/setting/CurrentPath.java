package org.dronewatch.setting;

import java.util.List;
import java.util.Map;
import java.util.Optional;

/** Replaces former names in the path of a setting with current ones. */
public final class CurrentPath {
    private final Object tree;
    private final FormerNames used;

    /**
     * Replaces names in the paths of some settings.
     *
     * @param tree the settings to which the paths apply
     * @param used receives the former names that are found
     */
    public CurrentPath(Object tree, FormerNames used) {
        this.tree = tree;
        this.used = used;
    }

    /**
     * The path with current names; the rest of an invalid path is left unchanged.
     *
     * @param path names separated by dots
     * @param place location of the path, for the warning
     */
    public String of(String path, String place) {
        String[] names = path.split("\\.", -1);
        Optional<?> here = Optional.of(tree);
        for (int depth = 0; depth < names.length && here.isPresent(); depth++) {
            Object value = here.get() instanceof Optional<?> optional ? optional.orElse(null) : here.get();
            if (value instanceof Record settings) {
                SettingsForm form = SettingsForm.of(settings.getClass());
                String current = form.currentName(names[depth]);
                if (!current.equals(names[depth])) {
                    used.add(form, names[depth], place);
                    names[depth] = current;
                }
            }
            here = child(value, names[depth]);
        }
        return String.join(".", names);
    }

    private static Optional<?> child(Object value, String name) {
        if (value instanceof Record settings) {
            return SettingsForm.of(settings.getClass()).part(name).map(part -> SettingsForm.get(settings, part));
        }
        if (value instanceof Map<?, ?> map) {
            return Optional.ofNullable(map.get(name));
        }
        boolean isIndex =
                value instanceof List<?> list && name.matches("\\d{1,6}") && Integer.parseInt(name) < list.size();
        return isIndex ? Optional.of(((List<?>) value).get(Integer.parseInt(name))) : Optional.empty();
    }
}
