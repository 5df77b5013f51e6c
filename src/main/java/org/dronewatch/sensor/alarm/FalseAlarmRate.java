package org.dronewatch.sensor.alarm;

/**
 * The rate of a sensor's false alarms. They begin independently of each other, with the same probability in every look
 * and in every cell: their number in a look is Poisson-distributed.
 *
 * @param perLook expected number of false alarms that begin in one look, 0 or more; this number times {@code looks} is
 *     at most {@link #MOST_PER_LOOK}
 * @param cells number of cells of the field of view that the sensor, or its tracker, distinguishes, 1 or more: only
 *     false alarms in the same cell confirm each other
 * @param looks number of consecutive looks for which a false alarm lasts, 1 or more: 1 for noise, more for a bird or an
 *     aircraft
 * @param rate looks per second, above 0, Hz
 */
public record FalseAlarmRate(double perLook, long cells, int looks, double rate) {
    /** The maximum expected number of false alarms that a look reports, including those that began earlier. */
    public static final double MOST_PER_LOOK = 1000.0;

    private static final double HOUR = 3600.0;

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException when there are too many false alarms, no cells or no looks
     */
    public FalseAlarmRate {
        if (!(perLook >= 0.0 && perLook * looks <= MOST_PER_LOOK)) {
            String lasting = looks > 1 ? ", each of which lasts for " + looks + " looks," : "";
            throw new IllegalArgumentException(
                    "falseAlarms: " + (float) perLook + " false alarms that begin in each look"
                            + lasting + " amount to " + (float) (perLook * looks)
                            + " at the same time; there must be 0 to " + (int) MOST_PER_LOOK);
        }
        if (cells < 1 || looks < 1 || !(rate > 0.0)) {
            throw new IllegalArgumentException("falseAlarms: " + cells + " cells, " + looks + " looks and a rate of "
                    + rate + " Hz: there must be at least one of each, and a rate above 0 Hz");
        }
    }

    /** Expected number of false alarms that begin in an hour. */
    public double perHour() {
        return perLook * rate * HOUR;
    }

    /** Expected number of false alarms that begin in one cell in one look. */
    public double perCell() {
        return perLook / cells;
    }

    /**
     * The probability that at least one false alarm begins in a given cell in a given look,
     * {@code 1 - exp(-perLook / cells)}.
     */
    public double probability() {
        return -Math.expm1(-perCell());
    }
}
