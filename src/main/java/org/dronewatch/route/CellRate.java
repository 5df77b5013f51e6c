package org.dronewatch.route;

import org.dronewatch.analysis.cell.ProbabilityStep;

/**
 * The rate at which one sensor detects a drone with one motion at positions near the centre of one cell. If the sensor
 * rejects low radial speeds, the rate follows from the fraction of the drone's signal that passes in flight: it lies
 * between the rates on two courses of the cell, one on which no more passes and one on which no less does; of several
 * on which the same fraction passes, that with the nearest heading is taken. For use by one thread.
 */
final class CellRate {
    /** If more than this fraction passes on the next course, lower fractions count as this one; as a power of ten. */
    private static final double NOTHING = -1.5;

    /** Otherwise, fractions below half of what passes on the next course count as that half; as a power of ten. */
    private static final double LESS = -Math.log10(2.0);

    /** By step of a probability, 1/s. */
    private final double[] rates;

    /** By course, the step of the probability. */
    private final int[] steps;

    /** By course, the fraction that passes at the centre of the cell. */
    private final double[] passes;

    /** By course, how near its heading is to that of the drone: the greater, the nearer. */
    private final double[] along;

    /** The rate where nothing passes, 1/s; NaN if it is not yet known. */
    private double ofNothing = Double.NaN;

    /** The rate where all of the signal passes, 1/s; NaN if it is not yet known. */
    private double ofAll = Double.NaN;

    /**
     * A rate that depends on the fraction that passes.
     *
     * @param rates the rate for each step of a probability, 1/s
     * @param steps the step of the probability on each course
     * @param passes the fraction that passes on each course, 0 to 1
     * @param along how near the heading of each course is to that of the drone: the greater, the nearer
     */
    CellRate(double[] rates, int[] steps, double[] passes, double[] along) {
        this.rates = rates;
        this.steps = steps;
        this.passes = passes;
        this.along = along;
    }

    /** The course on which no more passes than in flight, or -1. */
    private int below(double passing) {
        int below = -1;
        for (int course = 0; course < passes.length; course++) {
            boolean isNearer = below < 0
                    || passes[course] > passes[below]
                    || passes[course] == passes[below] && along[course] > along[below];
            below = passes[course] <= passing && isNearer ? course : below;
        }
        return below;
    }

    /**
     * The course on which no less passes than in flight, or -1.
     *
     * @param below the course on which no more passes, or -1
     */
    private int above(int below, double passing) {
        if (below >= 0 && passes[below] == passing) {
            return below;
        }
        int above = -1;
        for (int course = 0; course < passes.length; course++) {
            boolean isNearer = above < 0
                    || passes[course] < passes[above]
                    || passes[course] == passes[above] && along[course] > along[above];
            above = passes[course] > passing && isNearer ? course : above;
        }
        return above;
    }

    /**
     * The rate in flight, 1/s.
     *
     * @param passing the fraction of the signal that passes in flight, 0 to 1
     */
    double at(double passing) {
        // Sensors with a least radial speed let all or nothing pass.
        if (passing == 0.0) {
            ofNothing = Double.isNaN(ofNothing) ? between(0.0) : ofNothing;
            return ofNothing;
        }
        if (passing == 1.0) {
            ofAll = Double.isNaN(ofAll) ? between(1.0) : ofAll;
            return ofAll;
        }
        return between(passing);
    }

    private double between(double passing) {
        int below = below(passing);
        int above = above(below, passing);
        if (below < 0 || above < 0) {
            return rates[steps[Math.max(below, above)]];
        }
        if (steps[below] == steps[above]) {
            return rates[steps[below]];
        }
        double low = ProbabilityStep.probability(steps[below]);
        double high = ProbabilityStep.probability(steps[above]);
        return rates[ProbabilityStep.of(low + fraction(below, above, passing) * (high - low))];
    }

    /** The position of the flight between two courses, 0 to 1, by the level of the signal that passes. */
    private double fraction(int below, int above, double passing) {
        double to = Math.log10(passes[above]);
        double least = to > NOTHING ? NOTHING : to + LESS;
        double from = Math.max(least, Math.log10(passes[below]));
        return to > from ? (Math.max(from, Math.log10(passing)) - from) / (to - from) : 0.0;
    }

    /** The course on which the sensor sees most nearly what it sees in flight. */
    int course(double passing) {
        int below = below(passing);
        int above = above(below, passing);
        return below < 0 || above >= 0 && fraction(below, above, passing) >= 0.5 ? above : below;
    }
}
