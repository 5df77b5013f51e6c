package org.dronewatch.app.search;

import java.util.function.Function;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.app.console.Interruption;
import org.dronewatch.app.console.TaskProgress;
import org.dronewatch.placement.PlacementSolver;
import org.dronewatch.placement.SearchEnd;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.plan.CandidateAdvice;
import org.dronewatch.placement.plan.PlacePlan;
import org.dronewatch.placement.plan.PossibleLayouts;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.CheaperLayouts;
import org.dronewatch.placement.site.FrontSearch;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.placement.solver.ExactSolver;
import org.dronewatch.report.placement.PlaceMeasure;
import org.dronewatch.run.Stage;

/**
 * The inputs of a search for a placement, whatever its objective.
 *
 * @param plan what is asked for
 * @param stage stage of the plan's scene
 * @param store store of earlier assessments
 * @param limits limits of each choice among candidates
 * @param budgets maximum number of budgets for which the best layout is sought, including the full one
 * @param interruption interruption by the user, or at the end of the time limit
 * @param shown shows the progress
 */
public record PlaceTask(
        PlacePlan plan,
        Stage stage,
        LayerStore store,
        SolverLimits limits,
        int budgets,
        Interruption interruption,
        TaskProgress shown) {
    /**
     * A task whose stage and store are those of the plan's scene.
     *
     * @throws org.dronewatch.setting.InputException when no layout has the numbers of sensors that the plan asks for
     */
    public static PlaceTask of(
            PlacePlan plan, SolverLimits limits, int budgets, Interruption interruption, TaskProgress shown) {
        new PossibleLayouts(plan).check();
        plan.runner().adviseOnConditions();
        Stage stage = plan.runner().stage(plan.present());
        new CandidateAdvice(plan, stage.world()).giveTo(line -> shown.notes().accept("warning: " + line));
        LayerStore store = LayerStore.of(
                plan.present(),
                plan.runner().inputs().models(),
                LayerStore.standard(plan.runner().store(), shown.notes()));
        return new PlaceTask(plan, stage, store, limits, budgets, interruption, shown);
    }

    /** Solves problems with tables. */
    PlacementSolver solver() {
        return new ExactSolver();
    }

    /**
     * To be called once candidates are assessed. If the assessment was interrupted, a layout of those candidates that
     * were assessed is found nevertheless; otherwise, an interruption ends whatever is being done when it comes, such
     * as the attacks.
     */
    void assessed() {
        if (interruption.happened()) {
            interruption.letFinish();
        }
        limitTime();
    }

    /** To be called once the time of the search begins: if it is limited, so is the time of all that follows. */
    void limitTime() {
        limits.end().begin();
        if (Double.isFinite(limits.end().seconds())) {
            interruption.limit(limits.end().seconds() + SearchEnd.FOLLOW_UP);
        }
    }

    /** Runs a part of the work that reports how many steps it has done since the last time. */
    <T> T during(String part, long steps, Function<IntConsumer, T> work) {
        return shown.during(part, steps, work, interruption::happened);
    }

    /** The layouts, marked as lacking a part of their figures if that is missing because the time is up. */
    <L extends PlacedLayout> BudgetFront<L> checked(BudgetFront<L> front, LeftOut part, boolean isMissing) {
        return isMissing && interruption.isOutOfTime() ? front.without(part, limits) : front;
    }

    /** The best layouts for lower budgets. Values that are printed alike count as equal only if a gap is allowed. */
    <L extends PlacedLayout> BudgetFront<L> front(CheaperLayouts<L> cheaper) {
        FrontSearch<L> search = limits.gap() == 0.0
                ? new FrontSearch<>(cheaper)
                : new FrontSearch<>(cheaper, PlaceMeasure.of(plan)::text);
        return shown.during(
                "layouts for lower budgets", budgets - 1L, progress -> search.found(budgets, limits, progress));
    }
}
