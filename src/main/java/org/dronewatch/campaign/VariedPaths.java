package org.dronewatch.campaign;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;

/** Checks which paths of settings may vary or differ, so that no value silently overrides another. */
final class VariedPaths {
    private VariedPaths() {}

    /**
     * Checks that no path lies within another, and that none is the seed of the runs.
     *
     * @param paths paths of the settings that vary from case to case
     * @throws IllegalArgumentException when a path may not vary; its message begins with the path
     */
    static void check(Collection<String> paths) {
        List<String> before = new ArrayList<>();
        for (String path : paths) {
            checkSeed(path);
            checkApart(path, before);
            before.add(path);
        }
    }

    /**
     * Checks that a path does not lie within others that vary, nor they within it.
     *
     * @throws IllegalArgumentException when it does; its message begins with the path
     */
    static void checkApart(String path, Collection<String> others) {
        for (String other : others) {
            if (overlap(path, other)) {
                throw new IllegalArgumentException(
                        path + ": overlaps '" + other + "', which varies as well; one would override the other");
            }
        }
    }

    /**
     * Checks that a path is not that of the seed of the runs.
     *
     * @throws IllegalArgumentException when it is; its message begins with the path
     */
    static void checkSeed(String path) {
        if (path.equals(SensitivityCases.CHANCE)) {
            throw new IllegalArgumentException(
                    path + ": cannot be set, because each case has its own; set 'seed' of the campaign instead");
        }
    }

    /** Whether two paths are the same or one lies within the other. */
    static boolean overlap(String one, String other) {
        return one.equals(other) || one.startsWith(other + ".") || other.startsWith(one + ".");
    }
}
