package org.dronewatch.run.model;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Function;

/** Keeps the most recently used values, by their keys. Not thread-safe. */
final class Recent<K, V> {
    private final int most;
    private final Map<K, V> values = new LinkedHashMap<>(16, 0.75f, true);

    /**
     * Begins without any values.
     *
     * @param most how many values are kept
     */
    Recent(int most) {
        this.most = most;
    }

    /** The value of a key; null if there is none. */
    V get(K key) {
        return values.get(key);
    }

    /** Keeps a value, and forgets the least recently used one if there are too many. */
    void put(K key, V value) {
        values.put(key, value);
        if (values.size() > most) {
            values.remove(values.keySet().iterator().next());
        }
    }

    /** The value of a key, which is made if there is none. */
    V computeIfAbsent(K key, Function<K, V> make) {
        V known = values.get(key);
        if (known == null) {
            known = make.apply(key);
            put(key, known);
        }
        return known;
    }
}
