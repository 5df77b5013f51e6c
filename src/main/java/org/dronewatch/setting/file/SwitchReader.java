package org.dronewatch.setting.file;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingText;
import org.dronewatch.setting.Switchable;

/** Removes the {@code enabled} switches from settings by name, so that no kind of settings needs to know about them. */
final class SwitchReader {
    private final Problems problems;
    private final Set<String> off = new LinkedHashSet<>();

    SwitchReader(Problems problems) {
        this.problems = problems;
    }

    /** Names of the settings that are off. */
    Set<String> off() {
        return off;
    }

    /**
     * Settings by name without their switches.
     *
     * @param path path of the settings
     */
    Node.Mapping read(Node.Mapping all, String path) {
        Map<String, Node> rest = new LinkedHashMap<>(all.values());
        all.values().forEach((name, node) -> {
            if (node instanceof Node.Mapping one && one.values().containsKey(Switchable.ENABLED)) {
                read(name, one.values().get(Switchable.ENABLED), path);
                rest.put(name, one.without(List.of(Switchable.ENABLED)));
            }
        });
        return Node.Mapping.of(rest, all.keys(), all.mark());
    }

    private void read(String name, Node written, String path) {
        String text = written instanceof Node.Scalar scalar ? scalar.text() : "a list or mapping";
        try {
            if (!(boolean) SettingText.parse(boolean.class, Quantity.NUMBER, text)) {
                off.add(name);
            }
        } catch (IllegalArgumentException e) {
            problems.add(written.mark(), path + "." + name + "." + Switchable.ENABLED, e.getMessage());
        }
    }
}
