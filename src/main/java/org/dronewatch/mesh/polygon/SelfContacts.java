package org.dronewatch.mesh.polygon;

/**
 * Finds where the edges of a polygon cross or touch each other, by boxes around runs of edges. Clipping the ears of a
 * polygon that crosses itself gives a wrong area, after a time that may grow with the cube of its corners.
 */
final class SelfContacts {
    /** Pairs of edges that are looked at before the search is given up. */
    private static final long MAX_PAIRS = 200_000_000;

    /**
     * Contacts times corners up to which ears are clipped: bridges to holes touch, and cost a search of the polygon
     * each.
     */
    private static final long MAX_SEARCHES = 20_000_000;

    private static final int EDGES_IN_A_LEAF = 4;

    private final FlatPolygon polygon;
    private final int size;
    /** Least x and y, greatest x and y of each run of edges; the halves of run i are runs 2 i and 2 i + 1. */
    private final double[] boxes;

    private long pairs;
    private long contacts;
    private boolean crossed;

    private SelfContacts(FlatPolygon polygon) {
        this.polygon = polygon;
        this.size = polygon.size();
        this.boxes = new double[16 * size];
        enclose(1, 0, size);
    }

    /** Whether ears may be clipped: no edges cross, and not too many touch. */
    static boolean allowEars(FlatPolygon polygon) {
        SelfContacts contacts = new SelfContacts(polygon);
        contacts.within(1, 0, polygon.size());
        return !contacts.isHopeless();
    }

    private boolean isHopeless() {
        return crossed || pairs > MAX_PAIRS || contacts * size > MAX_SEARCHES;
    }

    private static boolean isLeaf(int from, int to) {
        return to - from <= EDGES_IN_A_LEAF;
    }

    private void enclose(int run, int from, int to) {
        int box = 4 * run;
        if (isLeaf(from, to)) {
            setBox(box, polygon.x(from), polygon.y(from), polygon.x(from), polygon.y(from));
            for (int i = from + 1; i <= to; i++) {
                double x = polygon.x(i % size);
                double y = polygon.y(i % size);
                extend(box, x, y, x, y);
            }
            return;
        }
        int middle = (from + to) >>> 1;
        enclose(2 * run, from, middle);
        enclose(2 * run + 1, middle, to);
        int half = 8 * run;
        setBox(box, boxes[half], boxes[half + 1], boxes[half + 2], boxes[half + 3]);
        extend(box, boxes[half + 4], boxes[half + 5], boxes[half + 6], boxes[half + 7]);
    }

    private void setBox(int box, double minX, double minY, double maxX, double maxY) {
        boxes[box] = minX;
        boxes[box + 1] = minY;
        boxes[box + 2] = maxX;
        boxes[box + 3] = maxY;
    }

    private void extend(int box, double minX, double minY, double maxX, double maxY) {
        boxes[box] = Math.min(boxes[box], minX);
        boxes[box + 1] = Math.min(boxes[box + 1], minY);
        boxes[box + 2] = Math.max(boxes[box + 2], maxX);
        boxes[box + 3] = Math.max(boxes[box + 3], maxY);
    }

    /** Compares the edges of a run with each other. */
    private void within(int run, int from, int to) {
        if (isHopeless()) {
            return;
        }
        if (isLeaf(from, to)) {
            for (int i = from; i < to; i++) {
                compare(i, i + 1, to);
            }
            return;
        }
        int middle = (from + to) >>> 1;
        within(2 * run, from, middle);
        within(2 * run + 1, middle, to);
        between(2 * run, from, middle, 2 * run + 1, middle, to);
    }

    /** Compares the edges of one run with those of a later one. */
    private void between(int a, int fromA, int toA, int b, int fromB, int toB) {
        if (isHopeless() || areApart(4 * a, 4 * b)) {
            return;
        }
        if (isLeaf(fromA, toA) && isLeaf(fromB, toB)) {
            for (int i = fromA; i < toA; i++) {
                compare(i, fromB, toB);
            }
        } else if (toA - fromA >= toB - fromB) {
            int middle = (fromA + toA) >>> 1;
            between(2 * a, fromA, middle, b, fromB, toB);
            between(2 * a + 1, middle, toA, b, fromB, toB);
        } else {
            int middle = (fromB + toB) >>> 1;
            between(a, fromA, toA, 2 * b, fromB, middle);
            between(a, fromA, toA, 2 * b + 1, middle, toB);
        }
    }

    private boolean areApart(int a, int b) {
        pairs++;
        return boxes[a] > boxes[b + 2]
                || boxes[b] > boxes[a + 2]
                || boxes[a + 1] > boxes[b + 3]
                || boxes[b + 1] > boxes[a + 3];
    }

    private void compare(int edge, int from, int to) {
        for (int other = Math.max(from, edge + 2); other < to; other++) {
            if (edge > 0 || other < size - 1) {
                pairs++;
                compare(edge, other);
            }
        }
    }

    private void compare(int edge, int other) {
        int edgeEnd = (edge + 1) % size;
        int otherEnd = (other + 1) % size;
        int sides = side(edge, edgeEnd, other) * side(edge, edgeEnd, otherEnd);
        int otherSides = side(other, otherEnd, edge) * side(other, otherEnd, edgeEnd);
        if (sides > 0 || otherSides > 0) {
            return;
        }
        if (sides < 0 && otherSides < 0) {
            crossed = true;
        } else if (overlap(edge, edgeEnd, other, otherEnd)) {
            contacts++;
        }
    }

    /** On which side of an edge a corner lies, 1 or -1; 0 where the rounding of corners may have put it there. */
    private int side(int a, int b, int c) {
        double area = polygon.doubleArea(a, b, c);
        double reach = distance(a, b) + distance(a, c);
        return Math.abs(area) <= polygon.coordinateError() * reach ? 0 : area > 0.0 ? 1 : -1;
    }

    private double distance(int a, int b) {
        return Math.abs(polygon.x(b) - polygon.x(a)) + Math.abs(polygon.y(b) - polygon.y(a));
    }

    private boolean overlap(int a, int aEnd, int b, int bEnd) {
        return Math.max(polygon.x(a), polygon.x(aEnd)) >= Math.min(polygon.x(b), polygon.x(bEnd))
                && Math.max(polygon.x(b), polygon.x(bEnd)) >= Math.min(polygon.x(a), polygon.x(aEnd))
                && Math.max(polygon.y(a), polygon.y(aEnd)) >= Math.min(polygon.y(b), polygon.y(bEnd))
                && Math.max(polygon.y(b), polygon.y(bEnd)) >= Math.min(polygon.y(a), polygon.y(aEnd));
    }
}
