package org.dronewatch.run.store;

import java.lang.ref.SoftReference;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.kdtree.TreeParts;

/**
 * The most recently used trees of this process, for programs that set up the same site several times. They are kept
 * only while there is memory to spare. Thread-safe.
 */
final class TreeMemory {
    /** The memory that this process shares. */
    static final TreeMemory SHARED = new TreeMemory();

    private static final int MOST = 8;

    private final Map<StoreKey, SoftReference<TreeParts>> trees = new LinkedHashMap<>(16, 0.75f, true);

    /** The tree with a key; empty if it is not kept, or no longer. */
    synchronized Optional<TreeParts> find(StoreKey key) {
        return Optional.ofNullable(trees.get(key)).map(SoftReference::get);
    }

    /** Keeps a tree, and forgets the least recently used one if there are too many. */
    synchronized void keep(StoreKey key, TreeParts tree) {
        trees.put(key, new SoftReference<>(tree));
        if (trees.size() > MOST) {
            trees.remove(trees.keySet().iterator().next());
        }
    }
}
