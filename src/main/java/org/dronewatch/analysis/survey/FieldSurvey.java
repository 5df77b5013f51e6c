package org.dronewatch.analysis.survey;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Function;
import java.util.function.IntConsumer;
import java.util.function.Supplier;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.field.DetectableHeights;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldAssessment;
import org.dronewatch.analysis.field.FieldRequest;
import org.dronewatch.analysis.field.InboundWarnings;
import org.dronewatch.analysis.field.VisibleHeights;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.parallel.Workers;
import org.dronewatch.scenario.SceneSettings;

/**
 * Where, how high and how early the sensors of a site detect a drone; or, after an interruption, as much of this as was
 * completed.
 *
 * @param grid the grid that was asked for
 * @param summary the coverage, cell by cell and in numbers; after an interruption, possibly of the lowest heights only
 * @param visible the lowest heights to which the sensors have a clear line of sight
 * @param detectable the lowest heights at which a sensor detects the drone
 * @param warnings the warnings of inbound flights
 * @param conditions the coverage of the scene as it is and under each condition that was asked for; empty if none was
 *     asked for
 * @param asked how many conditions were asked for
 */
public record FieldSurvey(
        FieldGrid grid,
        FieldSummary summary,
        Optional<VisibleHeights> visible,
        Optional<DetectableHeights> detectable,
        Optional<InboundWarnings> warnings,
        List<ConditionCoverage> conditions,
        int asked) {
    /** Copies the list: later changes by the caller have no effect. */
    public FieldSurvey {
        conditions = List.copyOf(conditions);
    }

    /** A survey without conditions. */
    public FieldSurvey(
            FieldGrid grid,
            FieldSummary summary,
            Optional<VisibleHeights> visible,
            Optional<DetectableHeights> detectable,
            Optional<InboundWarnings> warnings) {
        this(grid, summary, visible, detectable, warnings, List.of(), 0);
    }

    /**
     * Carries out a survey on the {@link Workers} of the calling thread; the result does not depend on their number.
     *
     * @param conditions conditions under which the site is assessed again; may be empty
     * @param stores stores of earlier assessments, for the settings of the scene as it is and under a condition
     * @param progress receives the number of cells that a sensor has looked at since the last call; from any thread
     * @param stopped called if this thread has been interrupted and at least one height is complete; it should clear
     *     the interrupt status, so that the complete heights can be summarised
     * @throws CancellationException when this thread is interrupted before any height is complete, or its interrupt
     *     status was not cleared
     */
    public static FieldSurvey of(
            FieldRequest request,
            List<FieldCondition> conditions,
            Function<SceneSettings, LayerStore> stores,
            IntConsumer progress,
            Runnable stopped) {
        LayerStore store = stores.apply(request.settings());
        DetectionField field = FieldAssessment.untilInterrupted(request, store, progress)
                .orElseThrow(() -> new CancellationException("interrupted"));
        Supplier<FieldSummary> summing = () -> FieldSummary.of(field, request.choice(), request.covered());
        boolean isWhole = field.grid().equals(request.grid());
        Optional<FieldSummary> summary = isWhole ? unlessInterrupted(summing) : Optional.empty();
        if (summary.isEmpty()) {
            stopped.run();
            return new FieldSurvey(
                    request.grid(),
                    summing.get(),
                    Optional.empty(),
                    Optional.empty(),
                    Optional.empty(),
                    List.of(),
                    conditions.size());
        }
        FieldSurvey survey = new FieldSurvey(
                request.grid(),
                summary.get(),
                unlessInterrupted(() -> VisibleHeights.of(request.settings(), request.stage(), request.grid())),
                unlessInterrupted(() -> DetectableHeights.of(summary.get().coverage(), progress)),
                unlessInterrupted(() -> InboundWarnings.of(
                        request.settings(),
                        request.stage(),
                        request.drone(),
                        request.grid(),
                        request.terms(),
                        request.covered(),
                        store.about(request.grid(), request.courses()),
                        field::excess,
                        progress)),
                under(conditions, request, summary.get(), stores, progress),
                conditions.size());
        if (!survey.isComplete()) {
            stopped.run();
        }
        return survey;
    }

    /** Carries out a survey without a store. */
    public static FieldSurvey of(
            FieldRequest request, List<FieldCondition> conditions, IntConsumer progress, Runnable stopped) {
        return of(request, conditions, settings -> LayerStore.NONE, progress, stopped);
    }

    /** Under those conditions that are assessed before an interruption. */
    private static List<ConditionCoverage> under(
            List<FieldCondition> conditions,
            FieldRequest request,
            FieldSummary asItIs,
            Function<SceneSettings, LayerStore> stores,
            IntConsumer progress) {
        List<ConditionCoverage> found = new ArrayList<>();
        for (FieldCondition condition : conditions) {
            unlessInterrupted(() -> ConditionCoverage.of(condition, request, asItIs.coverage(), stores, progress))
                    .ifPresent(found::add);
        }
        if (!found.isEmpty()) {
            found.add(0, ConditionCoverage.asItIs(asItIs));
        }
        return found;
    }

    /** An interrupted thread stays interrupted: whatever it begins afterwards ends at once. */
    private static <T> Optional<T> unlessInterrupted(Supplier<T> work) {
        try {
            return Optional.of(work.get());
        } catch (CancellationException e) {
            return Optional.empty();
        }
    }

    /** Whether nothing is missing. */
    public boolean isComplete() {
        return hasAllHeights()
                && visible.isPresent()
                && detectable.isPresent()
                && warnings.isPresent()
                && (asked == 0 || conditions.size() == asked + 1);
    }

    /** Whether the coverage includes all heights that were asked for. */
    public boolean hasAllHeights() {
        return summary.heights().size() == grid.heights().size();
    }
}
