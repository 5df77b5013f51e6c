package org.dronewatch.sensor.acoustic.edge;

/**
 * The edges of one path around an obstacle, in order, with their positions along the path and the angles by which the
 * path bends. Edges are numbered from 0.
 */
public final class EdgeSequence {
    private double detour = Double.POSITIVE_INFINITY;
    private int edges;
    private double bend;
    private double[] along = new double[8];
    private double[] turned = new double[8];

    EdgeSequence() {}

    void clear() {
        detour = Double.POSITIVE_INFINITY;
        edges = 0;
    }

    /** Takes the path that a band found last. */
    void take(RubberBand band, double straight, double longer) {
        detour = longer;
        edges = band.corners();
        if (along.length < edges) {
            along = new double[2 * edges];
            turned = new double[2 * edges];
        }
        bend = 0.0;
        double u = 0.0;
        double v = 0.0;
        double path = 0.0;
        double turning = 0.0;
        double direction = 0.0;
        for (int i = 0; i <= edges; i++) {
            double du = (i < edges ? band.u(i) : straight) - u;
            double dv = (i < edges ? band.v(i) : 0.0) - v;
            double next = Math.atan2(dv, du);
            if (i > 0) {
                turning += Math.abs(Math.IEEEremainder(next - direction, 2.0 * Math.PI));
                turned[i - 1] = turning;
            }
            path += Math.hypot(du, dv);
            if (i < edges) {
                along[i] = path;
                bend = Math.max(bend, band.bend(i));
            }
            direction = next;
            u += du;
            v += dv;
        }
    }

    /** The length of the path minus that of the straight line, m; infinity if there is no path. */
    public double detour() {
        return detour;
    }

    /** The number of edges. */
    public int count() {
        return edges;
    }

    /** Distance along the path from its beginning to an edge, m; the path may begin at the source or at the sensor. */
    public double along(int edge) {
        return along[edge];
    }

    /** The total angle by which the path bends at all edges up to and including a given one, rad. */
    public double turnUpTo(int edge) {
        return turned[edge];
    }

    /** The total angle by which the path bends at a given edge and all edges after it, rad. */
    public double turnFrom(int edge) {
        return turned[edges - 1] - (edge > 0 ? turned[edge - 1] : 0.0);
    }

    /**
     * The largest angle by which the outline of the obstacle bends at an edge of the path, rad: pi for the edge of a
     * sheet.
     */
    public double bend() {
        return bend;
    }
}
