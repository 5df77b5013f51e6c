package org.dronewatch.sensor.radio;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * The loss over knife edges, as the package describes it, by plain search in a plane: every corner is compared with a
 * string that is the highest of all straight lines between two of its points, and every distance is measured by its
 * length and direction. Lines of corners are in the coordinates u along the line from the origin to its end and t
 * above it, m; those whose first corner is also their last are closed.
 */
final class SlowDiffraction {
    private static final double NEAR = 1e-9;

    private final List<List<double[]>> lines;
    private final double length;
    private final double wavelength;
    private final List<double[]> string = new ArrayList<>();
    private final List<double[]> edges = new ArrayList<>();
    private boolean isClosed;

    SlowDiffraction(List<List<double[]>> lines, double length, double wavelength) {
        this.lines = lines;
        this.length = length;
        this.wavelength = wavelength;
        drawString();
        findEdges();
    }

    /** The loss, dB; infinite where no path leads over. */
    double loss() {
        double[] main = main();
        if (isClosed || main == null) {
            return isClosed ? Double.POSITIVE_INFINITY : 0;
        }
        double[] origin = {0, 0};
        double[] end = {length, 0};
        double beside = 0;
        double beyond = 0;
        for (double[] edge : edges) {
            double apart = Math.hypot(edge[0] - main[0], edge[1] - main[1]) / wavelength;
            double share = Math.max(0, Math.min(1, (apart - 5) / 45));
            if (edge[0] < main[0]) {
                beside = Math.max(beside, share * over(origin, main, edge));
            } else if (edge[0] > main[0]) {
                beyond = Math.max(beyond, share * over(main, end, edge));
            }
        }
        double most = over(origin, end, main);
        return most + Math.min(1, most / KnifeEdge.loss(0)) * (beside + beyond);
    }

    /** Where the edge with the greatest loss is; null if none has any. */
    double[] main() {
        double[] origin = {0, 0};
        double[] end = {length, 0};
        return edges.stream()
                .filter(edge -> over(origin, end, edge) > 0)
                .max(Comparator.comparingDouble(edge -> over(origin, end, edge)))
                .orElse(null);
    }

    private double over(double[] from, double[] to, double[] edge) {
        double distance = Math.hypot(edge[0] - from[0], edge[1] - from[1]);
        double angle = Math.atan2(edge[1] - from[1], edge[0] - from[0]) - Math.atan2(to[1] - from[1], to[0] - from[0]);
        double before = distance * Math.cos(angle);
        double beyond = Math.hypot(to[0] - from[0], to[1] - from[1]) - before;
        double v = KnifeEdge.parameter(distance * Math.sin(angle), before, beyond, wavelength);
        return KnifeEdge.loss(v);
    }

    private boolean isBetween(double u) {
        return u > 0 && u < length;
    }

    private void drawString() {
        string.add(new double[] {0, 0});
        string.add(new double[] {length, 0});
        List<List<double[]>> left = new ArrayList<>();
        lines.forEach(line -> left.addAll(above(line)));
        List<List<double[]>> taken = left.stream().filter(this::standsOnLine).toList();
        while (!taken.isEmpty() && !isClosed) {
            left.removeAll(taken);
            for (List<double[]> body : taken) {
                body.stream().filter(p -> isBetween(p[0]) && p[1] > 0).forEach(string::add);
                isClosed |= isPassingAnEnd(body);
            }
            taken = left.stream().filter(this::crossesString).toList();
        }
    }

    private boolean standsOnLine(List<double[]> body) {
        return body.stream().anyMatch(p -> p[1] == 0 && isBetween(p[0]));
    }

    private boolean isPassingAnEnd(List<double[]> body) {
        for (int i = 1; i < body.size(); i++) {
            double one = body.get(i - 1)[0];
            double other = body.get(i)[0];
            if (one < 0 != other < 0 || one < length != other < length) {
                return true;
            }
        }
        return false;
    }

    private boolean crossesString(List<double[]> body) {
        boolean isOver = false;
        boolean isUnder = false;
        for (int i = 1; i < body.size(); i++) {
            double[] p = body.get(i - 1);
            double[] q = body.get(i);
            List<double[]> here = new ArrayList<>(
                    Stream.of(p, q).filter(at -> at[0] >= 0 && at[0] <= length).toList());
            for (double[] at : string) {
                double share = (at[0] - p[0]) / (q[0] - p[0]);
                if (share > 0 && share < 1) {
                    here.add(new double[] {at[0], p[1] + share * (q[1] - p[1])});
                }
            }
            for (double[] at : here) {
                isOver |= at[1] > string(at[0]) + NEAR;
                isUnder |= at[1] < string(at[0]) - NEAR;
            }
        }
        return isOver && isUnder;
    }

    /** The height of the string: no straight line between two of its points is higher. */
    private double string(double u) {
        double highest = 0;
        for (double[] p : string) {
            for (double[] q : string) {
                if (p[0] <= u && u <= q[0] && p[0] < q[0]) {
                    highest = Math.max(highest, p[1] + (u - p[0]) / (q[0] - p[0]) * (q[1] - p[1]));
                }
            }
        }
        return highest;
    }

    /** The parts of a line of corners that lie above the straight line, with the points at which they begin or end. */
    private static List<List<double[]>> above(List<double[]> corners) {
        List<double[]> from = fromBelow(corners);
        List<List<double[]>> parts = new ArrayList<>();
        List<double[]> part = new ArrayList<>();
        for (int i = 0; i < from.size(); i++) {
            double[] q = from.get(i);
            double[] p = from.get(Math.max(0, i - 1));
            if (p[1] > 0 != q[1] > 0) {
                part.add(new double[] {p[0] + p[1] / (p[1] - q[1]) * (q[0] - p[0]), 0});
            }
            if (q[1] > 0) {
                part.add(q);
            } else if (!part.isEmpty()) {
                parts.add(part);
                part = new ArrayList<>();
            }
        }
        if (!part.isEmpty()) {
            parts.add(part);
        }
        return parts;
    }

    /** The same corners; those of a closed line from one below the straight line on, if there is one. */
    private static List<double[]> fromBelow(List<double[]> corners) {
        boolean isRing = corners.get(0) == corners.get(corners.size() - 1);
        for (int i = 0; isRing && i < corners.size(); i++) {
            if (corners.get(i)[1] <= 0) {
                List<double[]> turned = new ArrayList<>(corners.subList(i, corners.size()));
                turned.addAll(corners.subList(1, i + 1));
                return turned;
            }
        }
        return corners;
    }

    private void findEdges() {
        for (List<double[]> line : lines) {
            int last = line.size() - 1;
            boolean isRing = line.get(0) == line.get(last);
            for (int i = isRing ? 1 : 0; i <= last; i++) {
                double[] at = line.get(i);
                double[] before = i > 0 ? line.get(i - 1) : line.get(1);
                double[] after = i < last ? line.get(i + 1) : line.get(isRing ? 1 : last - 1);
                if (isBetween(at[0]) && at[1] <= string(at[0]) + NEAR && isOut(at, before, after)) {
                    edges.add(at);
                }
            }
        }
    }

    /** Whether the open sector with the upward direction in it is wider than a half-plane, by more than a degree. */
    private static boolean isOut(double[] at, double[] before, double[] after) {
        double one = Math.toDegrees(Math.atan2(before[0] - at[0], before[1] - at[1]));
        double other = Math.toDegrees(Math.atan2(after[0] - at[0], after[1] - at[1]));
        double between = Math.abs(one - other);
        return (one > 0 == other > 0 ? 360 - between : between) > 181;
    }
}
