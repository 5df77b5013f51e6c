package org.dronewatch.app;

import java.nio.charset.StandardCharsets;
import java.util.LinkedHashMap;
import java.util.Map;

/** Contents of files, each by a name that says what is wrong. */
final class NamedFiles {
    private final Map<String, byte[]> files = new LinkedHashMap<>();

    void add(String what, String text) {
        add(what, text.getBytes(StandardCharsets.UTF_8));
    }

    void add(String what, byte[] bytes) {
        if (files.put(what, bytes) != null) {
            throw new IllegalStateException("two files for " + what);
        }
    }

    Map<String, byte[]> all() {
        return files;
    }
}
