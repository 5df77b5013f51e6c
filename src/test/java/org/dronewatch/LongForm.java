package org.dronewatch;

/**
 * Checks that are repeated at many places or moments are repeated less often in the build. Their long form:
 * {@code mvn -q test -Dtest=NAME -Ddronewatch.long=true}.
 */
public final class LongForm {
    /** Whether the long form is asked for. */
    public static final boolean IS_ON = Boolean.getBoolean("dronewatch.long");

    private LongForm() {}

    /** How often a check is repeated. */
    public static int count(int inTheBuild, int inTheLongForm) {
        return IS_ON ? inTheLongForm : inTheBuild;
    }
}
