package org.dronewatch.sensor.radio;

import java.util.Arrays;
import java.util.function.IntPredicate;

/**
 * Deygout's construction for three edges (J. Deygout, "Multiple knife-edge diffraction of microwaves", IEEE
 * Transactions on Antennas and Propagation 14, 1966; without a correction): the main edge, which obstructs the line
 * most, and on either side of it the edge that most obstructs the line from the top of the main edge to that end.
 */
final class DeygoutEdges {
    /**
     * Edges no farther apart than this, in wavelengths, count as one edge, which the construction would otherwise count
     * twice.
     */
    private static final double ONE_EDGE = 5.0;

    /** From this distance on, in wavelengths, the second edge counts in full. */
    private static final double TWO_EDGES = 50.0;

    /**
     * The loss of an edge that the line just touches, dB. If the main edge has at least this loss, the other edges
     * count in full; below it, they count in proportion.
     */
    private static final double GRAZING = KnifeEdge.loss(0.0);

    private final Section section;
    private final boolean above;
    private final double wavelength;
    private final IntPredicate isEdge;

    private int mainPoint = -1;

    /**
     * @param section the section with its obstacles
     * @param above whether the edges on the side of positive t count, or those on the other side
     * @param wavelength wavelength, m
     * @param isEdge whether a point of the section is an edge; asked only where that would change the loss
     */
    DeygoutEdges(Section section, boolean above, double wavelength, IntPredicate isEdge) {
        this.section = section;
        this.above = above;
        this.wavelength = wavelength;
        this.isEdge = isEdge;
    }

    /** The loss of the three edges, dB. */
    double loss() {
        double[] start = {0.0, 0.0};
        double[] end = {section.length(), 0.0};
        double most = findMain(start, end);
        if (mainPoint < 0) {
            return 0.0;
        }
        double[] main = main();
        double beside = 0.0;
        double beyond = 0.0;
        for (int i = 0; i < section.points(); i++) {
            double u = section.u(i);
            double apart = Math.hypot(u - main[0], height(i) - main[1]) / wavelength;
            double share = Math.max(0.0, Math.min(1.0, (apart - ONE_EDGE) / (TWO_EDGES - ONE_EDGE)));
            if (share > 0.0 && u < main[0]) {
                double here = share * edgeLoss(start, main, i);
                beside = here > beside && isEdge.test(i) ? here : beside;
            } else if (share > 0.0 && u > main[0]) {
                double here = share * edgeLoss(main, end, i);
                beyond = here > beyond && isEdge.test(i) ? here : beyond;
            }
        }
        return most + Math.min(1.0, most / GRAZING) * (beside + beyond);
    }

    /** Finds the edge with the greatest loss, the first among equals, and returns that loss, dB. */
    private double findMain(double[] start, double[] end) {
        double most = 0.0;
        for (int i = 0; i < section.points(); i++) {
            double here = edgeLoss(start, end, i);
            boolean isMore = here > most || mainPoint >= 0 && here == most && isBefore(i, mainPoint);
            if (isMore && isEdge.test(i)) {
                most = here;
                mainPoint = i;
            }
        }
        return most;
    }

    /** The point of the edge that obstructs the line most, known after {@link #loss}; -1 for none. */
    int mainPoint() {
        return mainPoint;
    }

    /** The coordinates of that edge: u, and t counted positive towards this side, m; null if there is none. */
    double[] main() {
        return mainPoint < 0 ? null : edge(mainPoint);
    }

    private double height(int point) {
        return above ? section.t(point) : -section.t(point);
    }

    private boolean isBefore(int one, int other) {
        return Arrays.compare(edge(one), edge(other)) < 0;
    }

    private double[] edge(int point) {
        return new double[] {section.u(point), height(point)};
    }

    /** The loss at an edge of a wave between two points, dB. */
    private double edgeLoss(double[] from, double[] to, int point) {
        double du = to[0] - from[0];
        double dt = to[1] - from[1];
        double distance = Math.hypot(du, dt);
        if (!(distance > 0.0)) {
            return 0.0;
        }
        double u = section.u(point) - from[0];
        double t = height(point) - from[1];
        double along = (u * du + t * dt) / distance;
        double over = (t * du - u * dt) / distance;
        return KnifeEdge.loss(KnifeEdge.parameter(over, along, distance - along, wavelength));
    }
}
