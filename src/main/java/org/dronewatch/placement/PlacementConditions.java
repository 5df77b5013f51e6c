package org.dronewatch.placement;

import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;

/**
 * What a layout must comply with, in addition to the fixed candidates and exclusive positions of its table. Immutable.
 *
 * @param budget greatest sum of costs; infinite for no limit
 * @param atMost greatest number of chosen candidates; {@link Integer#MAX_VALUE} for no limit
 * @param kinds limits by kind
 * @param fold k of k-fold coverage: the value of a row is the k-th best among the values of the chosen candidates; 1 to
 *     100
 * @param anyoneLost the value that must remain after the worst loss of a single chosen candidate (see
 *     {@link CandidateLosses}); empty for no such condition
 * @param needsOneOf for each candidate that may be chosen only together with at least one of certain others, by its
 *     name: the names of these others, such as the sensors that can cue a camera on a positioner. A candidate with an
 *     empty set is never chosen; fixed candidates are chosen even if none of the others is
 */
public record PlacementConditions(
        double budget,
        int atMost,
        Map<String, KindLimits> kinds,
        int fold,
        OptionalDouble anyoneLost,
        Map<String, Set<String>> needsOneOf) {
    /** No conditions. */
    public static final PlacementConditions NONE = new PlacementConditions(
            Double.POSITIVE_INFINITY, Integer.MAX_VALUE, Map.of(), 1, OptionalDouble.empty(), Map.of());

    private static final int MOST_FOLD = 100;

    /** Checks the limits. */
    public PlacementConditions {
        if (!(budget >= 0.0)) {
            throw new IllegalArgumentException("budget " + budget + ": must be 0 or more");
        }
        if (atMost < 0) {
            throw new IllegalArgumentException("number of chosen candidates " + atMost + ": must be 0 or more");
        }
        if (fold < 1 || fold > MOST_FOLD) {
            throw new IllegalArgumentException("fold " + fold + ": must be 1 to " + MOST_FOLD);
        }
        kinds = Map.copyOf(new TreeMap<>(kinds));
        needsOneOf = Map.copyOf(needsOneOf);
    }

    /** A copy with another budget. */
    public PlacementConditions withBudget(double other) {
        return new PlacementConditions(other, atMost, kinds, fold, anyoneLost, needsOneOf);
    }

    /** A copy with another maximum number of chosen candidates. */
    public PlacementConditions withAtMost(int other) {
        return new PlacementConditions(budget, other, kinds, fold, anyoneLost, needsOneOf);
    }

    /** A copy with other limits by kind. */
    public PlacementConditions withKinds(Map<String, KindLimits> other) {
        return new PlacementConditions(budget, atMost, other, fold, anyoneLost, needsOneOf);
    }

    /** A copy with another {@linkplain #fold fold}. */
    public PlacementConditions withFold(int other) {
        return new PlacementConditions(budget, atMost, kinds, other, anyoneLost, needsOneOf);
    }

    /** A copy in which a value must remain after the worst loss. */
    public PlacementConditions withAnyoneLost(double value) {
        return new PlacementConditions(budget, atMost, kinds, fold, OptionalDouble.of(value), needsOneOf);
    }

    /**
     * A copy in which some candidates, by their names, are chosen only together with at least one of certain others.
     */
    public PlacementConditions withNeedsOneOf(Map<String, Set<String>> others) {
        return new PlacementConditions(budget, atMost, kinds, fold, anyoneLost, others);
    }
}
