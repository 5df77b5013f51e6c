package org.dronewatch.sensor.radio;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The path of a radio wave round the obstacles in a section, on one side of the line: over the tops, or past one side.
 * Its knife edges are the corners of the mesh that stick out on that side; their loss is that of Deygout's construction
 * for three edges (J. Deygout, "Multiple knife-edge diffraction of microwaves", IEEE Transactions on Antennas and
 * Propagation 14, 1966; without a correction): the edge that obstructs the line most, and on either side of it the one
 * that obstructs the line from its top most.
 */
final class DiffractedPath {
    /** Corners that bend less than this are part of a smooth surface, rad. */
    private static final double LEAST_BEND = Math.toRadians(1.0);

    /** Edges this near to each other, in wavelengths, are one; the construction would count it twice. */
    private static final double ONE_EDGE = 5.0;

    /** From this distance on, in wavelengths, the second edge counts in full. */
    private static final double TWO_EDGES = 50.0;

    /**
     * From this loss on, which is that of an edge that the line just touches, dB, the other edges count in full; they
     * fade in up to it.
     */
    private static final double GRAZING = KnifeEdge.loss(0.0);

    private static final double ON_CHAIN = 1e-9;

    private final Section section;
    private final boolean above;
    private final double wavelength;

    /** The edges, by u. */
    private final List<double[]> edges = new ArrayList<>();

    private List<double[]> chain = List.of();
    private double loss;
    private int mainPoint = -1;

    /**
     * @param section the section with its obstacles
     * @param above on which side of the line: that of positive t, or the other
     * @param wavelength m
     */
    DiffractedPath(Section section, boolean above, double wavelength) {
        this.section = section;
        this.above = above;
        this.wavelength = wavelength;
        if (findChain()) {
            collectEdges();
            loss = deygout();
        } else {
            loss = Double.POSITIVE_INFINITY;
        }
    }

    /** Diffraction loss, dB; infinite where no path leads round on this side. */
    double loss() {
        return loss;
    }

    /** A triangle at the edge that obstructs most, -1 for none. */
    int triangle() {
        for (int i = 0; mainPoint >= 0 && i < section.pieces(); i++) {
            if (section.start(i) == mainPoint || section.end(i) == mainPoint) {
                return section.triangle(i);
            }
        }
        return -1;
    }

    private double height(int point) {
        return above ? section.t(point) : -section.t(point);
    }

    private boolean isBetweenEnds(int point) {
        return section.u(point) > 0.0 && section.u(point) < section.length();
    }

    /**
     * A taut string over all bodies that are in the way: those that cross the line, and those that cross the string.
     */
    private boolean findChain() {
        boolean[] counted = new boolean[section.points()];
        for (int i = 0; i < section.points(); i++) {
            counted[i] = section.body(i) == i && section.blocks(i);
        }
        boolean grows = true;
        while (grows) {
            for (int i = 0; i < section.points(); i++) {
                if (counted[i] && section.isOpen(i, above)) {
                    return false;
                }
            }
            chain = hull(counted);
            grows = false;
            for (int i = 0; i < section.pieces(); i++) {
                boolean startsHigher = height(section.start(i)) > height(section.end(i));
                int whole = section.body(startsHigher ? section.start(i) : section.end(i));
                if (!counted[whole] && crossesChain(i)) {
                    counted[whole] = true;
                    grows = true;
                }
            }
        }
        return true;
    }

    private List<double[]> hull(boolean[] counted) {
        List<double[]> sorted = new ArrayList<>();
        for (int i = 0; i < section.points(); i++) {
            if (isBetweenEnds(i) && counted[section.body(i)]) {
                sorted.add(new double[] {section.u(i), height(i)});
            }
        }
        sorted.add(new double[] {section.length(), 0.0});
        sorted.sort(Arrays::compare);
        List<double[]> upper = new ArrayList<>();
        upper.add(new double[] {0.0, 0.0});
        for (double[] next : sorted) {
            while (upper.size() > 1 && turn(upper.get(upper.size() - 2), upper.get(upper.size() - 1), next) >= 0.0) {
                upper.remove(upper.size() - 1);
            }
            upper.add(next);
        }
        return upper;
    }

    /** Above 0 where three points turn to the left. */
    private static double turn(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    private boolean crossesChain(int piece) {
        double[] a = {section.u(section.start(piece)), height(section.start(piece))};
        double[] b = {section.u(section.end(piece)), height(section.end(piece))};
        for (int i = 1; i < chain.size() && chain.size() > 2; i++) {
            double[] p = chain.get(i - 1);
            double[] q = chain.get(i);
            if (turn(p, q, a) * turn(p, q, b) < 0.0 && turn(a, b, p) * turn(a, b, q) < 0.0) {
                return true;
            }
        }
        return false;
    }

    /** The corners that stick out towards this side, as far as they lie below the string. */
    private void collectEdges() {
        double[] first = new double[section.points()];
        double[] last = new double[section.points()];
        Arrays.fill(first, Double.POSITIVE_INFINITY);
        for (int i = 0; i < section.pieces(); i++) {
            int a = section.start(i);
            int b = section.end(i);
            turnBy(a, b, first, last);
            turnBy(b, a, first, last);
        }
        for (int i = 0; i < section.points(); i++) {
            double opening = first[i] + 2.0 * Math.PI - last[i];
            if (isBetweenEnds(i) && opening > Math.PI + LEAST_BEND && height(i) <= heightOfChain(i) + ON_CHAIN) {
                edges.add(new double[] {section.u(i), height(i), i});
            }
        }
        edges.sort(Arrays::compare);
    }

    /** Notes the direction of a piece from a point: its angle from straight up, clockwise. */
    private void turnBy(int from, int to, double[] first, double[] last) {
        double angle = Math.atan2(section.u(to) - section.u(from), height(to) - height(from));
        double positive = angle < 0.0 ? angle + 2.0 * Math.PI : angle;
        first[from] = Math.min(first[from], positive);
        last[from] = Math.max(last[from], positive);
    }

    private double heightOfChain(int point) {
        double at = section.u(point);
        int i = 1;
        while (chain.get(i)[0] < at) {
            i++;
        }
        double[] p = chain.get(i - 1);
        double[] q = chain.get(i);
        return q[0] > p[0] ? p[1] + (at - p[0]) * (q[1] - p[1]) / (q[0] - p[0]) : Math.max(p[1], q[1]);
    }

    private double deygout() {
        double[] start = {0.0, 0.0};
        double[] end = {section.length(), 0.0};
        double most = 0.0;
        double[] main = null;
        for (double[] edge : edges) {
            double here = edgeLoss(start, end, edge);
            if (here > most) {
                most = here;
                main = edge;
            }
        }
        if (main == null) {
            return 0.0;
        }
        mainPoint = (int) main[2];
        double beside = 0.0;
        double beyond = 0.0;
        for (double[] edge : edges) {
            double apart = Math.hypot(edge[0] - main[0], edge[1] - main[1]) / wavelength;
            double share = Math.max(0.0, Math.min(1.0, (apart - ONE_EDGE) / (TWO_EDGES - ONE_EDGE)));
            if (edge[0] < main[0]) {
                beside = Math.max(beside, share * edgeLoss(start, main, edge));
            } else if (edge[0] > main[0]) {
                beyond = Math.max(beyond, share * edgeLoss(main, end, edge));
            }
        }
        return most + Math.min(1.0, most / GRAZING) * (beside + beyond);
    }

    /** The loss of a wave between two points by an edge, dB. */
    private double edgeLoss(double[] from, double[] to, double[] edge) {
        double du = to[0] - from[0];
        double dt = to[1] - from[1];
        double distance = Math.hypot(du, dt);
        if (!(distance > 0.0)) {
            return 0.0;
        }
        double along = ((edge[0] - from[0]) * du + (edge[1] - from[1]) * dt) / distance;
        double over = ((edge[1] - from[1]) * du - (edge[0] - from[0]) * dt) / distance;
        return KnifeEdge.loss(KnifeEdge.parameter(over, along, distance - along, wavelength));
    }
}
