package org.dronewatch.buildings.io;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;

/** Joins ways of OpenStreetMap end to end into closed lines. */
final class OsmRings {
    private OsmRings() {}

    static boolean isClosed(long[] nodes) {
        return nodes.length > 3 && nodes[0] == nodes[nodes.length - 1];
    }

    /**
     * Joins open ways.
     *
     * @param open nodes of each, of which there are at least two; the list is emptied
     * @param closed receives the closed lines
     * @return how many lines remained open
     */
    static int join(List<long[]> open, List<long[]> closed) {
        int left = 0;
        while (!open.isEmpty()) {
            Deque<Long> line = new ArrayDeque<>();
            for (long node : open.remove(open.size() - 1)) {
                line.addLast(node);
            }
            boolean grew = true;
            while (grew && !line.peekFirst().equals(line.peekLast())) {
                grew = false;
                for (int i = 0; i < open.size() && !grew; i++) {
                    grew = append(line, open.get(i));
                    if (grew) {
                        open.remove(i);
                    }
                }
            }
            if (line.size() > 3 && line.peekFirst().equals(line.peekLast())) {
                closed.add(line.stream().mapToLong(Long::longValue).toArray());
            } else {
                left++;
            }
        }
        return left;
    }

    private static boolean append(Deque<Long> line, long[] way) {
        long end = line.peekLast();
        if (way[0] == end) {
            for (int i = 1; i < way.length; i++) {
                line.addLast(way[i]);
            }
            return true;
        }
        if (way[way.length - 1] == end) {
            for (int i = way.length - 2; i >= 0; i--) {
                line.addLast(way[i]);
            }
            return true;
        }
        return false;
    }
}
