package org.dronewatch.buildings.io;

import java.io.IOException;
import java.util.List;
import java.util.Map;

/** Receives the elements of an OpenStreetMap file in the order of the file. */
interface OsmElements {
    /** Maximum number of tags of an element, which no element of OpenStreetMap reaches; they are kept in a table. */
    int MOST_TAGS = 10_000;

    /** Maximum number of members of a relation, which no relation of OpenStreetMap reaches. */
    int MOST_MEMBERS = 100_000;

    /** Refuses elements with more tags. */
    static void checkTags(int count) throws IOException {
        if (count > MOST_TAGS) {
            throw new IOException("an element with more than " + MOST_TAGS + " tags");
        }
    }

    /** Refuses relations with more members. */
    static void checkMembers(int count) throws IOException {
        if (count > MOST_MEMBERS) {
            throw new IOException("a relation with more than " + MOST_MEMBERS + " members");
        }
    }

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
     * @param role its role in the relation, such as {@code outer}
     */
    record Member(long way, String role) {}
}
