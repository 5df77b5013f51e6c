package org.dronewatch;

/**
 * Checks that are repeated at many places or moments are repeated less often by default. Their long form:
 * {@code mvn -q test -Dtest=NAME -Ddronewatch.long=true}.
 */
public final class LongForm {
    /** Whether the long form is asked for. */
    public static final boolean IS_ON = Boolean.getBoolean("dronewatch.long");

    private LongForm() {}

    /**
     * The seed of a check with random input: in the long form another one each time, unless
     * {@code -Ddronewatch.seed=NUMBER} gives it.
     */
    public static long seed(long inTheBuild) {
        return IS_ON ? Long.getLong("dronewatch.seed", System.nanoTime()) : inTheBuild;
    }

    /** How often a check is repeated. */
    public static int count(int inTheBuild, int inTheLongForm) {
        return IS_ON ? inTheLongForm : inTheBuild;
    }
}
