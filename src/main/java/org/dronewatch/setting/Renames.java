package org.dronewatch.setting;

import java.lang.reflect.RecordComponent;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** The former names of a record's components; see {@link Formerly}. */
final class Renames {
    private Renames() {}

    /**
     * The current names by the former ones.
     *
     * @throws IllegalStateException when a former name could mean two components
     */
    static Map<String, String> of(Class<?> record) {
        List<RecordComponent> parts = List.of(record.getRecordComponents());
        Map<String, String> present = new LinkedHashMap<>();
        for (RecordComponent part : parts) {
            Formerly names = part.getAnnotation(Formerly.class);
            for (String former : names == null ? new String[0] : names.value()) {
                boolean isTaken =
                        parts.stream().anyMatch(other -> other.getName().equals(former));
                if (isTaken || present.putIfAbsent(former, part.getName()) != null) {
                    throw new IllegalStateException("record " + record.getName() + ": '" + former
                            + "', a former name of '" + part.getName() + "', is a name of another component");
                }
            }
        }
        return Collections.unmodifiableMap(present);
    }
}
