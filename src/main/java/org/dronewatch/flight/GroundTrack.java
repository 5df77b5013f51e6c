package org.dronewatch.flight;

import java.util.List;
import org.dronewatch.world.GroundPoint;

/** A path in plan view, divided into short segments by nodes, which include all its corners. */
public final class GroundTrack {
    /** Longest segment, m. */
    static final double STEP = 0.5;
    /** Maximum length of a path, m: a hundred thousand segments. */
    public static final double LONGEST = 100_000 * STEP;

    private final double[] x;
    private final double[] y;
    private final double[] along;
    private final int[] corners;

    /** A track through points that are 1 mm or more apart, with coordinates in m. */
    public GroundTrack(List<GroundPoint> points) {
        int pieces = 0;
        for (int i = 1; i < points.size(); i++) {
            pieces += pieces(points.get(i - 1), points.get(i));
        }
        corners = new int[points.size()];
        x = new double[pieces + 1];
        y = new double[pieces + 1];
        along = new double[pieces + 1];
        x[0] = points.get(0).x();
        y[0] = points.get(0).y();
        int last = 0;
        for (int i = 1; i < points.size(); i++) {
            last = append(points.get(i - 1), points.get(i), last);
            corners[i] = last;
        }
    }

    private static int pieces(GroundPoint from, GroundPoint to) {
        return (int) Math.ceil(from.distance(to) / STEP);
    }

    private int append(GroundPoint from, GroundPoint to, int last) {
        int pieces = pieces(from, to);
        double length = from.distance(to);
        for (int i = 1; i <= pieces; i++) {
            double share = i / (double) pieces;
            x[last + i] = from.x() + share * (to.x() - from.x());
            y[last + i] = from.y() + share * (to.y() - from.y());
            along[last + i] = along[last] + share * length;
        }
        return last + pieces;
    }

    /** The number of nodes, including both ends of the path. */
    public int size() {
        return x.length;
    }

    /** The index of the node at a point, given by its index among the points of the track. */
    public int corner(int point) {
        return corners[point];
    }

    /** The east coordinate of a node, m. */
    public double x(int node) {
        return x[node];
    }

    /** The north coordinate of a node, m. */
    public double y(int node) {
        return y[node];
    }

    /** The distance along the path, in plan view, from the start to a node, m. */
    public double along(int node) {
        return along[node];
    }
}
