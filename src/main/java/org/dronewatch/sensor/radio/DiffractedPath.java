package org.dronewatch.sensor.radio;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * The path of a radio wave around the obstacles in a section, on one side of the line: over the tops, or past one side.
 * Its knife edges are the corners of the mesh that stick out on that side; their loss is that of
 * {@linkplain DeygoutEdges Deygout's construction}.
 */
final class DiffractedPath {
    /** Corners that bend less than this are part of a smooth surface, rad. */
    private static final double LEAST_BEND = Math.toRadians(1.0);

    private static final double ON_CHAIN = 1e-9;

    /**
     * An edge at an antenna counts down to 0.55 wavelengths below the line, and no edge counts at a longer detour than
     * this, in wavelengths.
     */
    private static final double LOWEST = 0.55;

    private static final double LONGEST = 2.0;

    private final Section section;
    private final boolean above;
    private final double wavelength;

    private List<double[]> chain = List.of();
    private double loss;
    private final DeygoutEdges edges;
    private boolean isWhole = true;
    private double reach;

    /**
     * @param section the section with its obstacles
     * @param above whether the path leads around on the side of positive t, or on the other side
     * @param wavelength wavelength, m
     * @param isAll whether the section will not be enlarged any further: otherwise, the loss of a path that is not
     *     {@linkplain #isSettled settled} is not computed
     */
    DiffractedPath(Section section, boolean above, double wavelength, boolean isAll) {
        this.section = section;
        this.above = above;
        this.wavelength = wavelength;
        edges = new DeygoutEdges(section, above, wavelength, this::isEdge);
        loss = findChain(isAll) ? constructed() : Double.POSITIVE_INFINITY;
    }

    /**
     * Whether the loss is the same in every larger part of the site: all bodies around which the string is drawn are
     * complete, or go on beyond an end of the line, and no corner outside can be an edge that counts.
     *
     * @param sum sum of the distances of a point on the boundary of this part from both ends, m
     */
    boolean isSettled(double sum) {
        return isWhole && (loss == Double.POSITIVE_INFINITY || reach <= sum);
    }

    /** Diffraction loss, dB; infinite where no path leads around on this side. */
    double loss() {
        return loss;
    }

    /** A triangle at the edge that obstructs most; -1 for none. */
    int triangle() {
        int main = edges.mainPoint();
        for (int i = 0; main >= 0 && i < section.pieces().count(); i++) {
            if (section.pieces().start(i) == main || section.pieces().end(i) == main) {
                return section.pieces().triangle(i);
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
     * Stretches a taut string over all bodies that obstruct the path: those that cross the line, and those that cross
     * the string.
     */
    private boolean findChain(boolean isAll) {
        boolean[] counted = new boolean[section.points()];
        for (int i = 0; i < section.points(); i++) {
            counted[i] = section.body(i) == i && section.blocks(i);
        }
        boolean[] isNew = counted.clone();
        boolean grows = true;
        while (grows) {
            if (isAnyEnding(counted) || isAnyOpen(counted) || !isWhole && !isAll) {
                return false;
            }
            chain = hull(isNew);
            Arrays.fill(isNew, false);
            grows = false;
            for (int i = 0; i < section.pieces().count(); i++) {
                int start = section.pieces().start(i);
                int end = section.pieces().end(i);
                int whole = section.body(height(start) > height(end) ? start : end);
                if (!counted[whole] && mayCross(start, end) && crossesChain(start, end)) {
                    counted[whole] = true;
                    isNew[whole] = true;
                    grows = true;
                }
            }
        }
        return true;
    }

    /** Whether one of the bodies goes on beyond an end of the line. */
    private boolean isAnyEnding(boolean[] counted) {
        for (int i = 0; i < counted.length; i++) {
            if (counted[i] && section.isEnding(i, above)) {
                return true;
            }
        }
        return false;
    }

    /** Whether one of the bodies goes on beyond this part of the site; also notes whether all of them are complete. */
    private boolean isAnyOpen(boolean[] counted) {
        boolean isOpen = false;
        for (int i = 0; i < counted.length; i++) {
            if (counted[i]) {
                isOpen = isOpen || section.isOpen(i, above);
                isWhole = isWhole && !section.isPartial(i, above);
            }
        }
        isWhole = isWhole && !isOpen;
        return isOpen;
    }

    /** The string over the bodies over which it already passed, and over others. */
    private List<double[]> hull(boolean[] others) {
        List<double[]> sorted = new ArrayList<>();
        for (int i = 0; i < section.points(); i++) {
            // The string never hangs below the line.
            if (height(i) > 0.0 && others[section.body(i)] && isBetweenEnds(i)) {
                sorted.add(new double[] {section.u(i), height(i)});
            }
        }
        if (chain.isEmpty()) {
            sorted.add(new double[] {section.length(), 0.0});
        } else {
            sorted.addAll(chain.subList(1, chain.size()));
        }
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

    /** Above 0 if a path through three points turns to the left at the second. */
    private static double turn(double[] a, double[] b, double[] c) {
        return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    }

    /** Whether a piece may cross the string, which hangs between the ends and not below the line. */
    private boolean mayCross(int start, int end) {
        double first = section.u(start);
        double last = section.u(end);
        return (height(start) > 0.0 || height(end) > 0.0)
                && (first > 0.0 || last > 0.0)
                && (first < section.length() || last < section.length());
    }

    private boolean crossesChain(int start, int end) {
        double[] a = {section.u(start), height(start)};
        double[] b = {section.u(end), height(end)};
        for (int i = 1; i < chain.size() && chain.size() > 2; i++) {
            double[] p = chain.get(i - 1);
            double[] q = chain.get(i);
            if (turn(p, q, a) * turn(p, q, b) < 0.0 && turn(a, b, p) * turn(a, b, q) < 0.0) {
                return true;
            }
        }
        return false;
    }

    /**
     * Whether a corner between the ends sticks out towards this side and lies below the string, and is therefore an
     * edge.
     */
    private boolean isEdge(int point) {
        if (!isBetweenEnds(point) || height(point) > heightOfChain(point) + ON_CHAIN) {
            return false;
        }
        double first = Double.POSITIVE_INFINITY;
        double last = 0.0;
        SectionPieces pieces = section.pieces();
        for (int end = pieces.firstAt(point); end >= 0; end = pieces.nextAt(end)) {
            double angle = angle(point, pieces.otherEnd(end));
            first = Math.min(first, angle);
            last = Math.max(last, angle);
        }
        return first + 2.0 * Math.PI - last > Math.PI + LEAST_BEND;
    }

    /** The direction of a piece from a point: its angle from straight up, clockwise. */
    private double angle(int from, int to) {
        double angle = Math.atan2(section.u(to) - section.u(from), height(to) - height(from));
        return angle < 0.0 ? angle + 2.0 * Math.PI : angle;
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

    private double constructed() {
        double constructed = edges.loss();
        reach = reach(edges.main());
        return constructed;
    }

    /**
     * The greatest sum of the distances from both ends of a point at which there can be an edge with a loss: it lies
     * below the string and at most {@link #LOWEST} wavelengths below a line from the main edge to an end. Where that
     * line is steep, the edge may also lie beyond its end, between the perpendiculars to the section's own line.
     */
    private double reach(double[] main) {
        double most = 0.0;
        for (double[] point : chain) {
            most = Math.max(most, detour(point));
        }
        double steepest = 0.0;
        if (main != null) {
            most = Math.max(most, detour(main));
            steepest = Math.abs(main[1]) / Math.min(main[0], section.length() - main[0]);
        }
        return most + wavelength * (LONGEST + 2.0 * LOWEST * (1.0 + steepest));
    }

    private double detour(double[] point) {
        return Math.hypot(point[0], point[1]) + Math.hypot(section.length() - point[0], point[1]);
    }
}
