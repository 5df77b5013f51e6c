package org.dronewatch.buildings.io;

import java.util.List;
import java.util.Map;

/** Receives the elements of an OpenStreetMap file in its order. */
interface OsmElements {
    /** A node, degrees. */
    void node(long id, double longitude, double latitude);

    /** A node that is not only a corner of something else. */
    void taggedNode(Map<String, String> tags);

    /** A way through nodes; the arrays and maps are kept. */
    void way(long id, long[] nodes, Map<String, String> tags);

    /** A relation; the lists and maps are kept. */
    void relation(long id, List<Member> ways, Map<String, String> tags);

    /**
     * A way in a relation.
     *
     * @param way its number
     * @param role what it is there, such as {@code outer}
     */
    record Member(long way, String role) {}
}
