package org.dronewatch.buildings.io;

import java.util.Arrays;
import java.util.Map;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.input.HeapBudget;

/** The coordinates of nodes of OpenStreetMap by their identifiers, without an object for each. */
final class OsmNodes {
    private static final int MOST = 30_000_000;

    /** Bytes of a node, in tables that have just grown. */
    private static final int NODE = 100;

    private static final int WAY = 160;
    /** Bytes of a node of a way, and of a corner of the outline that is made of it. */
    private static final int CORNER = 24;

    private static final int TAG = 160;

    private final String file;
    private final HeapBudget budget;
    private final LongIndex numbers = new LongIndex();
    private double[] coordinates = new double[1 << 12];

    /** A collection without nodes; {@code file} is for messages. */
    OsmNodes(String file, HeapBudget budget) {
        this.file = file;
        this.budget = budget;
    }

    /**
     * Reserves the memory for a way with some nodes and tags.
     *
     * @throws InputException when there is too little
     */
    void takeMemoryOfWay(int corners, Map<String, String> tags) {
        long bytes = WAY + (long) CORNER * corners + (long) TAG * tags.size();
        for (Map.Entry<String, String> tag : tags.entrySet()) {
            bytes += 2L * (tag.getKey().length() + tag.getValue().length());
        }
        budget.take(bytes);
    }

    boolean contains(long id) {
        return numbers.get(id) >= 0;
    }

    boolean containsAny(long[] ids) {
        return Arrays.stream(ids).anyMatch(this::contains);
    }

    boolean containsAll(long[] ids) {
        return Arrays.stream(ids).allMatch(this::contains);
    }

    /**
     * Adds a node, degrees; one that is there already stays as it is.
     *
     * @throws InputException when there are too many
     */
    void add(long id, double longitude, double latitude) {
        int number = numbers.size();
        if (contains(id)) {
            return;
        }
        if (number >= MOST) {
            throw new InputException(file + ": more than " + MOST + " nodes near the origin: choose a smaller radius");
        }
        budget.take(NODE);
        numbers.put(id, number);
        if (2 * number + 2 > coordinates.length) {
            coordinates = Arrays.copyOf(coordinates, 2 * coordinates.length);
        }
        coordinates[2 * number] = longitude;
        coordinates[2 * number + 1] = latitude;
    }

    /** Longitude and latitude of each of some nodes in turn, all of which must be there. */
    double[] line(long[] ids, int from, int to) {
        double[] line = new double[2 * (to - from)];
        for (int i = from; i < to; i++) {
            int node = numbers.get(ids[i]);
            line[2 * (i - from)] = coordinates[2 * node];
            line[2 * (i - from) + 1] = coordinates[2 * node + 1];
        }
        return line;
    }

    /** The corners of a closed way, whose last node is its first, without repeating it. */
    double[] ring(long[] closed) {
        return line(closed, 0, closed.length - 1);
    }
}
