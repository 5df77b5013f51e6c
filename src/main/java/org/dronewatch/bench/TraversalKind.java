package org.dronewatch.bench;

import java.util.Locale;
import org.dronewatch.kdtree.KDTraversal;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.SequentialTraversal;
import org.dronewatch.kdtree.StackTraversal;

/** The ways through a tree that can be measured. */
public enum TraversalKind {
    /** Ordered, with a stack: the default. */
    STACK,
    /** Stackless, leaf by leaf from the root. */
    SEQUENTIAL;

    /** A traversal of this kind for one thread. */
    public KDTraversal create(KDTree tree) {
        return this == STACK ? new StackTraversal(tree) : new SequentialTraversal(tree);
    }

    /** As it is written on the command line. */
    @Override
    public String toString() {
        return name().toLowerCase(Locale.ROOT);
    }
}
