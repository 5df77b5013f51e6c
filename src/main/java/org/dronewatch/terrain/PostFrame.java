package org.dronewatch.terrain;

import org.dronewatch.geo.MapTransform;
import org.dronewatch.geometry.Position;
import org.dronewatch.terrain.io.Lattice;

/**
 * Where posts are in the world frame. A map is curved so little over a site that a polynomial through a few of its
 * points, which are transformed one by one, gives all others: with {@value #NODES} nodes a side (Chebyshev nodes, so
 * that the polynomial does not oscillate), the difference is below a micrometre over a hundred kilometres. A height is
 * added along the vertical of the post.
 *
 * <p>Immutable; a {@link Row} is for one thread.
 */
final class PostFrame {
    private static final int NODES = 10;

    /** East, north and up of the post at height 0, then of a metre of its vertical. */
    private static final int QUANTITIES = 6;

    private static final double SPAN = 1000.0;

    private final int columns;
    private final int rows;
    private final double[][][] coefficients = new double[QUANTITIES][NODES][NODES];

    /** The frame of posts of a grid on a map. */
    PostFrame(Lattice lattice, int columns, int rows, MapTransform map) {
        this.columns = columns;
        this.rows = rows;
        double[][][] values = new double[QUANTITIES][NODES][NODES];
        for (int j = 0; j < NODES; j++) {
            double row = 0.5 * (rows - 1) * (1.0 + node(j));
            for (int i = 0; i < NODES; i++) {
                double column = 0.5 * (columns - 1) * (1.0 + node(i));
                double x = lattice.xAt(column, row);
                double y = lattice.yAt(column, row);
                Position low = map.inWorld(x, y, 0.0);
                Position high = map.inWorld(x, y, SPAN);
                values[0][j][i] = low.x();
                values[1][j][i] = low.y();
                values[2][j][i] = low.z();
                values[3][j][i] = (high.x() - low.x()) / SPAN;
                values[4][j][i] = (high.y() - low.y()) / SPAN;
                values[5][j][i] = (high.z() - low.z()) / SPAN;
            }
        }
        for (int q = 0; q < QUANTITIES; q++) {
            transform(values[q], coefficients[q]);
        }
    }

    private static double node(int k) {
        return Math.cos(Math.PI * (k + 0.5) / NODES);
    }

    /** Coefficients of Chebyshev polynomials of row and column. */
    private static void transform(double[][] values, double[][] target) {
        for (int b = 0; b < NODES; b++) {
            for (int a = 0; a < NODES; a++) {
                double sum = 0.0;
                for (int j = 0; j < NODES; j++) {
                    for (int i = 0; i < NODES; i++) {
                        sum += values[j][i]
                                * Math.cos(Math.PI * b * (j + 0.5) / NODES)
                                * Math.cos(Math.PI * a * (i + 0.5) / NODES);
                    }
                }
                target[b][a] = sum * (a == 0 ? 1.0 : 2.0) * (b == 0 ? 1.0 : 2.0) / (NODES * NODES);
            }
        }
    }

    /** The posts of one row after another. */
    Row newRow() {
        return new Row();
    }

    /** The posts of a row; one thread at a time. */
    final class Row {
        private final double[][][] known = new double[rows][][];
        private double[][] polynomials;
        private double u;

        /** Goes to a row. */
        void to(int row) {
            if (known[row] == null) {
                known[row] = polynomials(2.0 * row / (rows - 1) - 1.0);
            }
            polynomials = known[row];
        }

        private double[][] polynomials(double v) {
            double[][] found = new double[QUANTITIES][NODES];
            for (int q = 0; q < QUANTITIES; q++) {
                for (int a = 0; a < NODES; a++) {
                    double next = 0.0;
                    double afterNext = 0.0;
                    for (int b = NODES - 1; b > 0; b--) {
                        double here = 2.0 * v * next - afterNext + coefficients[q][b][a];
                        afterNext = next;
                        next = here;
                    }
                    found[q][a] = v * next - afterNext + coefficients[q][0][a];
                }
            }
            return found;
        }

        /** Goes to a column of the row. */
        void column(int column) {
            u = 2.0 * column / (columns - 1) - 1.0;
        }

        /** Clenshaw's sum. */
        private double at(double[] polynomial) {
            double next = 0.0;
            double afterNext = 0.0;
            for (int a = NODES - 1; a > 0; a--) {
                double here = 2.0 * u * next - afterNext + polynomial[a];
                afterNext = next;
                next = here;
            }
            return u * next - afterNext + polynomial[0];
        }

        /** z of the post in the world frame at a height on the map, m. */
        double up(double height) {
            return at(polynomials[2]) + height * at(polynomials[5]);
        }

        /** The height on the map of a z in the world frame. */
        private double height(double up) {
            return (up - at(polynomials[2])) / at(polynomials[5]);
        }

        /** East of the post where it has this z in the world frame, m. */
        double east(double up) {
            return at(polynomials[0]) + height(up) * at(polynomials[3]);
        }

        /** North of the post where it has this z in the world frame, m. */
        double north(double up) {
            return at(polynomials[1]) + height(up) * at(polynomials[4]);
        }
    }
}
