package org.dronewatch.placement.plan;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.placement.CandidateLosses;
import org.dronewatch.placement.PlacementConditions;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.positioner.SearchPattern;
import org.dronewatch.sensor.DirectionFinding;
import org.dronewatch.sensor.Mounted;

/**
 * Which sensors cue the sensors on positioners. To count as turned to the drone, a sensor on a positioner needs a cue
 * from a sensor that measures directions: one of those that the settings of the positioner name or, if they name none,
 * any other in the layout except sensors on positioners that are at rest until they are cued themselves. Sensors that
 * are kept are cued only by those that their settings name.
 */
public final class Cues {
    private final PlacePlan plan;
    private final boolean isCued;

    /** The cues of a plan. */
    public Cues(PlacePlan plan) {
        this.plan = plan;
        this.isCued = plan.pointing() == FieldTerms.Turning.CUED;
    }

    /**
     * By the name of each candidate on a positioner, the names of the candidates that can cue it, at least one of which
     * must be in a layout with this candidate; empty if sensors on positioners search instead.
     */
    public Map<String, Set<String>> needed() {
        return cueing();
    }

    /**
     * The names of the sensors of a layout that count as turned to the drone, though no sensor of the layout cues them.
     */
    public List<String> uncued(List<SiteCandidate> layout) {
        Set<String> names = layout.stream().map(SiteCandidate::name).collect(Collectors.toSet());
        return cueing().entrySet().stream()
                .filter(one -> names.contains(one.getKey()))
                .filter(one -> one.getValue().stream().noneMatch(names::contains))
                .map(Map.Entry::getKey)
                .toList();
    }

    /** By the name of each sensor of a layout whose loss leaves others without a cue, the names of those others. */
    public Map<String, List<String>> uncuedWithout(List<SiteCandidate> layout) {
        CandidateLosses losses = new CandidateLosses(
                layout.stream().map(SiteCandidate::name).toList(), PlacementConditions.NONE.withNeedsOneOf(cueing()));
        List<Integer> all = IntStream.range(0, layout.size()).boxed().toList();
        Map<String, List<String>> uncued = new LinkedHashMap<>();
        all.forEach(lost -> uncued.put(layout.get(lost).name(), losses.idle(all, lost)));
        uncued.values().removeIf(List::isEmpty);
        return uncued;
    }

    /**
     * Which sensors of a layout count as turned to the drone, and which sensors, not themselves on positioners, cue
     * them.
     */
    public Cueing cueing(List<SiteCandidate> layout) {
        Map<String, Set<String>> all = cueing();
        List<String> turning = layout.stream()
                .map(SiteCandidate::name)
                .filter(all::containsKey)
                .toList();
        return new Cueing(
                turning,
                layout.stream()
                        .filter(one -> !all.containsKey(one.name()))
                        .filter(one ->
                                turning.stream().anyMatch(name -> all.get(name).contains(one.name())))
                        .toList());
    }

    /**
     * Who cues whom in a layout.
     *
     * @param turning names of the sensors that count as turned to the drone
     * @param cueing the sensors, not themselves on positioners, that cue any of them
     */
    public record Cueing(List<String> turning, List<SiteCandidate> cueing) {}

    /** By the name of each candidate on a positioner: those that cue it. */
    private Map<String, Set<String>> cueing() {
        Map<String, Set<String>> cueing = new LinkedHashMap<>();
        for (SiteCandidate one : plan.candidates()) {
            Optional<PositionerSettings> positioner = Mounted.positioner(one.sensor());
            if (isCued && positioner.isPresent()) {
                cueing.put(one.name(), cueing(one, positioner.get()));
            }
        }
        return cueing;
    }

    private Set<String> cueing(SiteCandidate turning, PositionerSettings positioner) {
        // A kept sensor is as the scene has it: without cues, it stays at rest, or searches.
        boolean takesAny = positioner.cues().isEmpty() && !turning.candidate().fixed();
        Set<String> names = new HashSet<>();
        for (SiteCandidate other : plan.candidates()) {
            boolean isNamed = positioner.cues().contains(other.name());
            boolean measures = other.sensor().as(DirectionFinding.class).isPresent();
            if (!other.name().equals(turning.name()) && measures && (isNamed || takesAny && !isAtRest(other))) {
                names.add(other.name());
            }
        }
        return names;
    }

    private static boolean isAtRest(SiteCandidate sensor) {
        return Mounted.positioner(sensor.sensor())
                .filter(positioner -> positioner.search() instanceof SearchPattern.Rest)
                .isPresent();
    }
}
