package org.dronewatch.route;

/**
 * The two courses of a cell between which a flight lies by the fraction of the drone's signal that passes: on one
 * course no more passes than in flight, on the other no less. Of several courses on which the same fraction passes, the
 * one with the nearest heading is taken. For one thread.
 */
final class CourseBracket {
    /** A fraction below this counts like this one; as a power of ten. */
    private static final double NOTHING = -1.5;

    private final double passing;
    private int below = -1;
    private int above = -1;
    private double passingBelow;
    private double passingAbove;
    private double alongBelow;
    private double alongAbove;

    /**
     * A bracket without courses.
     *
     * @param passing the fraction of the signal that passes in flight, 0 to 1
     */
    CourseBracket(double passing) {
        this.passing = passing;
    }

    /**
     * Takes a course into account.
     *
     * @param course its number
     * @param passes the fraction of the signal that passes on it, 0 to 1
     * @param along the greater, the nearer its heading is to that of the drone
     */
    void take(int course, double passes, double along) {
        boolean isNearerBelow = passes > passingBelow || passes == passingBelow && along > alongBelow;
        if (passes <= passing && (below < 0 || isNearerBelow)) {
            below = course;
            passingBelow = passes;
            alongBelow = along;
        }
        boolean isNearerAbove = passes < passingAbove || passes == passingAbove && along > alongAbove;
        if (passes >= passing && (above < 0 || isNearerAbove)) {
            above = course;
            passingAbove = passes;
            alongAbove = along;
        }
    }

    /** The course on which less passes; that on which more does, if there is none. */
    int below() {
        return below < 0 ? above : below;
    }

    /** The course on which more passes; that on which less does, if there is none. */
    int above() {
        return above < 0 ? below : above;
    }

    /** The place of the flight between the two, 0 to 1, by the level of the signal that passes. */
    double fraction() {
        double low = decades(passingBelow);
        double high = decades(passingAbove);
        return below >= 0 && above >= 0 && high > low ? (decades(passing) - low) / (high - low) : 0.0;
    }

    private static double decades(double passing) {
        return Math.max(NOTHING, Math.log10(passing));
    }
}
