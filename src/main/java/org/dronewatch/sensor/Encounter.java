package org.dronewatch.sensor;

/**
 * An encounter between a drone and the observer of a sensor's pictures: a person, or a program that performs equally
 * well. The probability P of a target task is the fraction of observers who can perform it with unlimited time, not an
 * independent chance in each picture. So one number u is drawn for each encounter, and the observer can find the drone
 * only while {@code P >= u}. The observer then searches, and finds it at the rate {@code P / 3.4 s}. With a constant
 * P, the fraction of observers who have found it after the time t is
 *
 * <pre>
 * p(t) = P (1 - exp(-P t / 3.4 s))
 * </pre>
 *
 * <p>at any frame rate: each picture covers the time since the last one, and the search is memoryless, so the success
 * in each picture can be drawn independently. The search time is that of the ACQUIRE model (Howe, in "The Infrared and
 * Electro-Optical Systems Handbook", vol. 4, 1993). Observers differ, and each of them searches at random: these are
 * two separate random effects, and tests with observers show both (the documentation of cameras has the sources).
 *
 * <p>Once found, the drone remains detected while {@code P >= u}, without another search. An encounter begins when a
 * drone can be seen at all (P above 0), and ends once it has been out of sight for more than {@link #GAP}: if it comes
 * back later, that is a new encounter with a new draw. Passing behind a tree does not end an encounter; a minute behind
 * a hill does.
 *
 * @param index number of the encounter of this sensor with this drone, from 0
 * @param isFollowed whether the observer knows where the drone is, so that a positioner can follow it: the drone is
 *     detected, though perhaps not recognised or identified yet
 * @param isFound whether the observer has performed the sensor's task
 */
public record Encounter(long index, boolean isFollowed, boolean isFound) {
    /** Mean time of a search by an observer who is certain to succeed, s. */
    public static final double SEARCH_TIME = 3.4;

    /**
     * The longest time for which a drone may be out of sight within one encounter, s: about three times the search time
     * (an assumption), after which the observer has to search again. For a sensor with a low rate, the limit is 1.5
     * times the interval between two looks, if that is longer.
     */
    public static final double GAP = 10.0;

    private static final double LOOKS = 1.5;

    /** The purpose of the number that an observer draws for an encounter. */
    private static final String OBSERVER = "observer";

    /** The first encounter at its beginning. */
    static final Encounter FIRST = new Encounter(0, false, false);

    /**
     * The time for which a drone may be out of sight of a sensor within one encounter, s.
     *
     * @param rate looks per second, Hz
     */
    static double gap(double rate) {
        return Math.max(GAP, LOOKS / rate);
    }

    /** This encounter after a look in which the drone could be seen. */
    Encounter with(Observation seen) {
        return or(new Encounter(index, seen.sighting().isPresent(), seen.isDetected()));
    }

    /**
     * This encounter combined with the other one, which follows from a second observation of the drone in the same
     * look.
     */
    Encounter or(Encounter other) {
        return new Encounter(index, isFollowed || other.isFollowed, isFound || other.isFound);
    }

    /** The encounter that follows this one. */
    Encounter next() {
        return new Encounter(index + 1, false, false);
    }

    /**
     * The number u drawn for the observer in this encounter. The observer can find the drone while the probability is
     * at least u.
     *
     * @return above 0 and at most 1, so that an invisible drone is never found
     */
    public double draw(long seed, String sensor, String drone) {
        return 1.0 - Draws.stream(seed, sensor, drone, index, OBSERVER).nextDouble();
    }

    /**
     * The threshold for the probability of a look: the number drawn for the observer if the drone is known, is found in
     * this look, or could not be found anyway; infinite while the observer could find the drone but has not.
     *
     * @param isKnown whether the observer need not search
     * @param drone name of the drone
     * @param rate looks per second, Hz
     * @param probability probability of the look, 0 to 1
     */
    double threshold(boolean isKnown, Look look, String drone, double rate, double probability) {
        double able = draw(look.seed(), look.sensor(), drone);
        boolean isSearching = probability >= able && !isKnown;
        return isSearching && !isSuccessful(look, drone, rate, probability) ? Double.POSITIVE_INFINITY : able;
    }

    /**
     * Whether a search succeeds in the time that a look represents; the probability of success is
     * {@code 1 - exp(-P time / 3.4 s)}.
     */
    private static boolean isSuccessful(Look look, String drone, double rate, double probability) {
        // Nobody has searched before the run begins.
        double time = Math.min(1.0 / rate, look.time());
        double success = -StrictMath.expm1(-probability * time / SEARCH_TIME);
        return look.random(drone, Look.DETECTION).nextDouble() < success;
    }
}
