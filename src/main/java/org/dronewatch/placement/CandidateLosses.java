package org.dronewatch.placement;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The part of a layout that still works after the loss of one of its candidates: all others, except those that need at
 * least one of certain candidates ({@link PlacementConditions#needsOneOf}) and have lost the last of these, such as a
 * camera on a positioner without the only sensor that cued it. Immutable; thread-safe.
 */
public final class CandidateLosses {
    private final List<String> names;
    private final Map<String, Set<String>> needs;

    /**
     * The losses of some candidates.
     *
     * @param names names of the candidates
     * @param conditions state which candidates need at least one of certain others
     */
    public CandidateLosses(List<String> names, PlacementConditions conditions) {
        this.names = List.copyOf(names);
        this.needs = conditions.needsOneOf();
    }

    /**
     * The chosen candidates that still work without the lost one, in the same order.
     *
     * @param chosen indices of the chosen candidates in the list of names
     * @param lost index of the lost candidate, which is one of them
     */
    public List<Integer> remaining(List<Integer> chosen, Integer lost) {
        List<Integer> remaining = new ArrayList<>(chosen);
        remaining.remove(lost);
        Set<String> unserved = unserved(chosen);
        boolean isChanged = true;
        while (isChanged) {
            Set<String> idle = unserved(remaining);
            idle.removeAll(unserved);
            isChanged = remaining.removeIf(one -> idle.contains(names.get(one)));
        }
        return remaining;
    }

    /**
     * The names of the other chosen candidates that stop working without the lost one.
     *
     * @param chosen indices of the chosen candidates in the list of names
     * @param lost index of the lost candidate, which is one of them
     */
    public List<String> idle(List<Integer> chosen, Integer lost) {
        List<Integer> remaining = remaining(chosen, lost);
        return chosen.stream()
                .filter(one -> !one.equals(lost) && !remaining.contains(one))
                .map(names::get)
                .toList();
    }

    /** The names of the chosen candidates that need at least one of certain others, none of which is chosen. */
    private Set<String> unserved(List<Integer> chosen) {
        Set<String> has = new HashSet<>();
        chosen.forEach(one -> has.add(names.get(one)));
        Set<String> unserved = new HashSet<>(has);
        unserved.removeIf(name -> !needs.containsKey(name) || !Collections.disjoint(needs.get(name), has));
        return unserved;
    }
}
