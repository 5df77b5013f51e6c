package org.dronewatch.sensor.alarm;

/**
 * The azimuths over which the bearings of a sensor's false alarms are uniformly distributed.
 *
 * @param centre azimuth of the centre, clockwise from north, rad
 * @param width width, above 0 and at most 2 pi, rad
 */
public record AzimuthSpan(double centre, double width) {
    /** The full circle. */
    public static final AzimuthSpan ALL = new AzimuthSpan(0.0, 2.0 * Math.PI);

    /** Checks the width. */
    public AzimuthSpan {
        if (!(width > 0.0 && width <= 2.0 * Math.PI + 1e-9)) {
            throw new IllegalArgumentException("width " + width + " rad must be above 0 and at most 2 pi");
        }
    }

    /**
     * The azimuth at a fraction of the width, rad.
     *
     * @param fraction 0 at the counter-clockwise end of the span to 1 at its clockwise end
     */
    public double at(double fraction) {
        return centre + (fraction - 0.5) * width;
    }

    /**
     * The probability that a bearing in this span lies within an angle of a given azimuth, on either side.
     *
     * @param azimuth the given azimuth, clockwise from north, rad
     * @param angle the angle, 0 to pi, rad
     */
    public double probabilityWithin(double angle, double azimuth) {
        double offset = Math.IEEEremainder(azimuth - centre, 2.0 * Math.PI);
        double covered = 0.0;
        // The other arc may reach round to this span on both sides.
        for (int turn = -1; turn <= 1; turn++) {
            double from = offset + turn * 2.0 * Math.PI - angle;
            covered += Math.max(0.0, Math.min(0.5 * width, from + 2.0 * angle) - Math.max(-0.5 * width, from));
        }
        return Math.min(1.0, covered / width);
    }
}
