package org.dronewatch.placement.solver;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.KindLimits;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.placement.PlacementProblem;

/** The conditions of a problem by index, without the one about losses. Immutable; thread-safe. */
final class Rules {
    final int size;
    final double[] cost;
    final double budget;
    final int atMost;

    /** By candidate: the exclusive place that it takes; -1 for none. */
    final int[] place;

    final int places;

    /** By candidate: the limited kind that it is of; -1 for none. */
    final int[] kind;

    final int[] kindAtLeast;
    final int[] kindAtMost;

    /** The candidates that are always chosen, ascending. */
    final int[] fixed;

    /** By candidate: those of which it needs one, ascending; null if it needs none. */
    final int[][] needs;

    private final boolean[] isFixed;
    private final boolean hasNeeds;

    /** By place: whether all its candidates are of one limited kind, or of none. */
    final boolean[] isNested;

    Rules(PlacementProblem problem) {
        List<Candidate> candidates = problem.table().candidates();
        PlacementConditions conditions = problem.conditions();
        size = candidates.size();
        cost = candidates.stream().mapToDouble(Candidate::cost).toArray();
        budget = conditions.budget() * (1.0 + PlacementProblem.ROUNDING);
        atMost = conditions.atMost();
        List<String> places = candidates.stream()
                .map(Candidate::exclusive)
                .filter(name -> !name.isEmpty())
                .distinct()
                .toList();
        this.places = places.size();
        place = candidates.stream()
                .mapToInt(candidate -> places.indexOf(candidate.exclusive()))
                .toArray();
        List<Map.Entry<String, KindLimits>> kinds =
                new ArrayList<>(conditions.kinds().entrySet());
        kinds.sort(Map.Entry.comparingByKey());
        List<String> names = kinds.stream().map(Map.Entry::getKey).toList();
        kind = candidates.stream()
                .mapToInt(candidate -> names.indexOf(candidate.kind()))
                .toArray();
        kindAtLeast =
                kinds.stream().mapToInt(entry -> entry.getValue().atLeast()).toArray();
        kindAtMost = kinds.stream().mapToInt(entry -> entry.getValue().atMost()).toArray();
        fixed = IntStream.range(0, size)
                .filter(number -> candidates.get(number).fixed())
                .toArray();
        isNested = nested();
        List<String> all = candidates.stream().map(Candidate::name).toList();
        needs = all.stream()
                .map(conditions.needsOneOf()::get)
                .map(others -> others == null
                        ? null
                        : others.stream()
                                .mapToInt(all::indexOf)
                                .filter(other -> other >= 0)
                                .sorted()
                                .toArray())
                .toArray(int[][]::new);
        isFixed = new boolean[size];
        for (int candidate : fixed) {
            isFixed[candidate] = true;
        }
        hasNeeds = Arrays.stream(needs).anyMatch(Objects::nonNull);
    }

    boolean isFixed(int candidate) {
        return isFixed[candidate];
    }

    /** Whether a candidate needs no other, or one of those that it needs is in the choice. */
    boolean isServed(int candidate, IntPredicate isChosen) {
        return needs[candidate] == null || Arrays.stream(needs[candidate]).anyMatch(isChosen);
    }

    /** How many candidates of a choice, not fixed, lack another that they need. */
    int lacking(int[] chosen) {
        int lacking = 0;
        for (int candidate : chosen) {
            lacking += isFixed[candidate] || isServed(candidate, chosen) ? 0 : 1;
        }
        return lacking;
    }

    private boolean isServed(int candidate, int[] chosen) {
        return isServed(candidate, other -> contains(chosen, other));
    }

    static boolean contains(int[] chosen, int candidate) {
        return Arrays.stream(chosen).anyMatch(one -> one == candidate);
    }

    /** Whether the loss of one of some candidates stops another of them, which needed it. */
    boolean stopsOthers(int[] chosen, int lost) {
        return hasNeeds && remaining(chosen, lost).length < chosen.length - 1;
    }

    /** Which candidates still work without one of them: {@link org.dronewatch.placement.CandidateLosses}. */
    int[] remaining(int[] chosen, int lost) {
        int[] remaining =
                Arrays.stream(chosen).filter(candidate -> candidate != lost).toArray();
        int before = -1;
        while (remaining.length != before) {
            before = remaining.length;
            int[] all = remaining;
            remaining = Arrays.stream(all)
                    .filter(candidate -> isServed(candidate, all) || !isServed(candidate, chosen))
                    .toArray();
        }
        return remaining;
    }

    private boolean[] nested() {
        boolean[] nested = new boolean[places];
        Arrays.fill(nested, true);
        int[] kindOfPlace = new int[places];
        Arrays.fill(kindOfPlace, -2);
        for (int candidate = 0; candidate < size; candidate++) {
            int at = place[candidate];
            if (at >= 0) {
                nested[at] &= kindOfPlace[at] == -2 || kindOfPlace[at] == kind[candidate];
                kindOfPlace[at] = kind[candidate];
            }
        }
        return nested;
    }

    int kinds() {
        return kindAtLeast.length;
    }
}
