package org.dronewatch.analysis.field;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.layer.LayerStore;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.SceneSettings;

/**
 * Assesses all enabled sensors of a scene in all cells of a grid, height by height, on the {@link Workers} of the
 * calling thread; the result does not depend on their number.
 */
public final class FieldAssessment {
    private FieldAssessment() {}

    /**
     * The field of a scene.
     *
     * @param settings settings of one run
     * @param stage world and drones of that run
     * @param drone name of the drone that is put into the cells
     * @param courses courses on which the drone flies, at least one
     * @param terms terms on which the drone counts as detected
     * @param progress receives the number of cells that a sensor has looked at since the last call; from any thread
     * @throws IllegalArgumentException when there is no such drone
     * @throws CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static DetectionField of(
            SceneSettings settings,
            Stage stage,
            String drone,
            FieldGrid grid,
            List<Course> courses,
            FieldTerms terms,
            IntConsumer progress) {
        // Which course counts, and with which probability, does not matter before it is evaluated.
        FieldRequest asked =
                new FieldRequest(settings, stage, drone, grid, courses, FieldCoverage.Choice.WORST, terms, 1.0);
        return of(asked, LayerStore.NONE, progress);
    }

    /** The field of a scene for {@link FieldTerms#ONE_LOOK one look}. */
    public static DetectionField of(
            SceneSettings settings,
            Stage stage,
            String drone,
            FieldGrid grid,
            List<Course> courses,
            IntConsumer progress) {
        return of(settings, stage, drone, grid, courses, FieldTerms.ONE_LOOK, progress);
    }

    /**
     * The field of a request; only what is not yet in the store is assessed.
     *
     * @param asked the request; its choice of a course and the probability that counts as covered have no effect
     * @param store store of earlier assessments
     */
    public static DetectionField of(FieldRequest asked, LayerStore store, IntConsumer progress) {
        return assessed(DetectionField.unassessed(asked, store, progress), asked, progress);
    }

    /**
     * The field of a request in the cells of a field that was assessed before, possibly for other sensors: which cells
     * are inside something solid is not determined again.
     *
     * @param like a field of the same site and grid
     * @throws IllegalArgumentException when the grid differs
     */
    public static DetectionField of(FieldRequest asked, DetectionField like, LayerStore store, IntConsumer progress) {
        return assessed(like.unassessedLikeThis(asked, store, progress), asked, progress);
    }

    private static DetectionField assessed(DetectionField field, FieldRequest asked, IntConsumer progress) {
        for (int height = 0; height < asked.grid().heights().size(); height++) {
            field.assess(height, progress);
        }
        return field;
    }

    /**
     * The field of a request; if this thread is interrupted, only with those heights at which all cells have been
     * assessed, and empty if there are none. The interrupt status is kept.
     *
     * @param store store of earlier assessments
     */
    public static Optional<DetectionField> untilInterrupted(
            FieldRequest asked, LayerStore store, IntConsumer progress) {
        int whole = 0;
        DetectionField field = null;
        try {
            field = DetectionField.unassessed(asked, store, progress);
            for (; whole < asked.grid().heights().size(); whole++) {
                field.assess(whole, progress);
            }
            return Optional.of(field);
        } catch (CancellationException e) {
            return whole == 0 ? Optional.empty() : Optional.of(field.upTo(whole));
        }
    }
}
