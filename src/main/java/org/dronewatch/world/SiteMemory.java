package org.dronewatch.world;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Supplier;
import org.dronewatch.bvh.TracingIndex;

/**
 * A cache of results that runs compute from their sites without drones, such as what a camera sees of the site, so that
 * thousands of runs on one site share them. When the results take more memory than intended, those least recently used
 * are dropped, and computed again when they are next needed. Thread-safe.
 */
public final class SiteMemory {
    private final long most;
    private final Map<Key, Kept> kept = new LinkedHashMap<>(16, 0.75f, true);
    private long made;

    /** A result that is kept; it may grow while it is in use. */
    public interface Kept {
        /** The memory that the result takes now, bytes. */
        long bytes();
    }

    /** An index is compared by identity, and all else by its contents. */
    record Key(TracingIndex index, Object what) {}

    /**
     * An empty cache.
     *
     * @param most the maximum memory of the results that are kept when a new one is added, bytes
     */
    public SiteMemory(long most) {
        this.most = most;
    }

    synchronized <T extends Kept> T get(Key key, Class<T> type, Supplier<T> make) {
        Kept known = kept.get(key);
        if (known == null) {
            dropOldest();
            known = make.get();
            made++;
            kept.put(key, known);
        }
        return type.cast(known);
    }

    private void dropOldest() {
        long bytes = bytes();
        Iterator<Kept> oldest = kept.values().iterator();
        while (bytes > most && oldest.hasNext()) {
            bytes -= oldest.next().bytes();
            oldest.remove();
        }
    }

    /** The number of results computed so far, including those dropped. */
    public synchronized long made() {
        return made;
    }

    /** The memory that everything kept now takes, bytes. */
    public synchronized long bytes() {
        return kept.values().stream().mapToLong(Kept::bytes).sum();
    }
}
