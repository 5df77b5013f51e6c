package org.dronewatch.route;

import org.dronewatch.route.exposure.LegMotion;

/**
 * The contribution of a sensor that rejects low radial speeds to the exposure on a part of a leg that lies between the
 * centres of the same cells: of this contribution, only the part due to those cells whose rate depends on the position.
 * The places at which the drone becomes visible or is lost are found exactly, so that no leg gains by ending a little
 * beyond them, and the mean of a leg is that of its pieces. For a single use; not thread-safe.
 */
final class UnsteadyPart {
    /** Shorter pieces than this fraction of the longest are not divided. */
    private static final double SHORT = 1e-6;

    private final SensorRates sensor;

    /** By corner; null where the rate is the same at all positions. */
    private final CellRate[] cells;

    private final CellCorners corners;
    private final LegPart part;
    private final LegMotion motion;

    /** The length of a piece that is not divided, as a fraction of the part. */
    private double shortest;

    private double latest = Double.NaN;
    private double passesLatest;
    private double rateLatest;

    UnsteadyPart(SensorRates sensor, CellRate[] cells, CellCorners corners, LegPart part, LegMotion motion) {
        this.sensor = sensor;
        this.cells = cells;
        this.corners = corners;
        this.part = part;
        this.motion = motion;
    }

    /**
     * The mean rate, 1/s.
     *
     * @param finest the greatest length of a piece, as a fraction of the leg
     */
    double mean(double finest) {
        int pieces = (int) Math.ceil(part.length() / finest);
        shortest = SHORT / pieces;
        double sum = 0.0;
        double from = 0.0;
        double passesFrom = passing(0.0);
        for (int piece = 1; piece <= pieces; piece++) {
            double to = (double) piece / pieces;
            double passesTo = passing(to);
            sum += between(from, passesFrom, to, passesTo);
            from = to;
            passesFrom = passesTo;
        }
        return sum;
    }

    /** The fraction of the signal that passes at a fraction of the part. */
    private double passing(double share) {
        return sensor.passingInFlight(part.x(share), part.y(share), part.z(share), motion);
    }

    /** The rate at a fraction of the part; that at which a piece ends is that at which the next one begins. */
    private double rate(double share, double passing) {
        if (share != latest || passing != passesLatest) {
            latest = share;
            passesLatest = passing;
            rateLatest = weighted(share, passing);
        }
        return rateLatest;
    }

    private double weighted(double share, double passing) {
        corners.weigh(part.x(share), part.y(share), part.z(share));
        double sum = 0.0;
        for (int corner = 0; corner < CellCorners.COUNT; corner++) {
            double weight = corners.weight(corner);
            sum += cells[corner] != null && weight > 0.0 ? weight * cells[corner].at(passing) : 0.0;
        }
        return sum;
    }

    /** The integral between two fractions of the part; the drone may be visible at one of them only. */
    private double between(double from, double passesFrom, double to, double passesTo) {
        if (passesFrom > 0.0 == passesTo > 0.0) {
            return alike(from, passesFrom, to, passesTo);
        }
        double low = from;
        double high = to;
        double passesLow = passesFrom;
        double passesHigh = passesTo;
        while (high - low > shortest) {
            double middle = 0.5 * (low + high);
            double passes = passing(middle);
            if (passes > 0.0 == passesFrom > 0.0) {
                low = middle;
                passesLow = passes;
            } else {
                high = middle;
                passesHigh = passes;
            }
        }
        return alike(from, passesFrom, low, passesLow) + alike(high, passesHigh, to, passesTo);
    }

    /**
     * The integral between two fractions of the part if the drone is visible at both, or at neither: by Simpson's rule,
     * unless the middle differs.
     */
    private double alike(double from, double passesFrom, double to, double passesTo) {
        double middle = 0.5 * (from + to);
        double passes = passing(middle);
        if (passes > 0.0 != passesFrom > 0.0 && to - from > shortest) {
            return between(from, passesFrom, middle, passes) + between(middle, passes, to, passesTo);
        }
        return (to - from) / 6.0 * (rate(from, passesFrom) + 4.0 * rate(middle, passes) + rate(to, passesTo));
    }
}
