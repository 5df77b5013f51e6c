package org.dronewatch.report.placement;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.run.Stage;
import tools.jackson.databind.node.ObjectNode;

/** What a search for placements found for one objective, as it is printed and written. */
public interface PlaceResults {
    /** The best layouts for several budgets. */
    BudgetFront<? extends PlacedLayout> front();

    /** The best layout for the whole budget. */
    default PlacedLayout best() {
        return front().best();
    }

    /** Whether anything that was asked for is missing because of an interruption. */
    boolean isInterrupted();

    /**
     * These results, marked as lacking a part that the time limit cut short.
     *
     * @param limits limits of the search
     */
    PlaceResults without(LeftOut part, SolverLimits limits);

    /** Whether nothing that was asked for is missing because of an interruption or a limit. */
    default boolean complete() {
        return front().complete() && !isInterrupted();
    }

    /** Describes the values of the objective in words. */
    PlaceMeasure measure();

    /**
     * States in a sentence that the layout achieves less, by a closer assessment, than the search promises; empty if it
     * does not, or if there is no closer assessment.
     */
    default Optional<String> shortfall() {
        return Optional.empty();
    }

    /** What remains without the sensor whose loss is worst, in a sentence; empty if it is not known. */
    default Optional<String> worstLoss() {
        return new PlaceTable(best(), measure()).worstLoss();
    }

    /** The lines of the results: tables and sentences. */
    List<String> lines();

    /**
     * Sentences that end with the commands that reproduce these figures. They have no full stop, so that a command can
     * be copied up to the end of the line.
     *
     * @param layout the file in which the layout has been written as a scene, as a command-line argument, quoted if
     *     necessary
     */
    List<String> reproduction(String layout);

    /** The contents of {@code place.json}. Equal inputs give the same bytes for any number of threads. */
    ObjectNode toJson();

    /**
     * What the report says about this objective, with its pictures, drawn on the
     * {@link org.dronewatch.parallel.Workers} of the calling thread.
     *
     * @param stage the site
     */
    PlaceChapter chapter(Stage stage) throws IOException;
}
