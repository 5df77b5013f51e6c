package org.dronewatch.bench;

import java.util.ArrayList;
import java.util.List;

/**
 * Curves of a cost as a function of one quantity.
 *
 * @param name short name, for file names
 * @param title title of the diagram
 * @param xLabel the quantity, with its unit
 * @param yLabel the cost, with its unit
 * @param lines the lines
 */
public record CostCurves(String name, String title, String xLabel, String yLabel, List<Line> lines) {
    /** Copies the list: later changes by the caller have no effect. */
    public CostCurves {
        lines = List.copyOf(lines);
    }

    /**
     * One line.
     *
     * @param name name of the line
     * @param x the quantity
     * @param y the cost
     */
    public record Line(String name, List<Double> x, List<Double> y) {
        /** Copies the lists: later changes by the caller have no effect. */
        public Line {
            x = List.copyOf(x);
            y = List.copyOf(y);
        }
    }

    /** Collects the points of a line. */
    static final class Points {
        private final String name;
        private final List<Double> x = new ArrayList<>();
        private final List<Double> y = new ArrayList<>();

        Points(String name) {
            this.name = name;
        }

        void add(double quantity, double cost) {
            x.add(quantity);
            y.add(cost);
        }

        Line line() {
            return new Line(name, x, y);
        }
    }
}
