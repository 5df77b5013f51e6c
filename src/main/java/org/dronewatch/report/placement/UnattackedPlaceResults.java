package org.dronewatch.report.placement;

import java.io.IOException;
import java.util.List;
import org.dronewatch.placement.site.BudgetFront;
import org.dronewatch.placement.site.PlacedLayout;
import org.dronewatch.run.Stage;
import tools.jackson.databind.node.ObjectNode;

/**
 * What a search for placements found, without the attacks that were to be flown: an interruption has left them out.
 *
 * @param found by the search
 */
public record UnattackedPlaceResults(PlaceResults found) implements PlaceResults {
    @Override
    public BudgetFront<? extends PlacedLayout> front() {
        return found.front();
    }

    @Override
    public boolean isInterrupted() {
        return true;
    }

    @Override
    public PlaceMeasure measure() {
        return found.measure();
    }

    @Override
    public List<String> lines() {
        return found.lines();
    }

    @Override
    public ObjectNode toJson() {
        ObjectNode root = found.toJson();
        root.put(PlaceFile.COMPLETE, complete());
        return root;
    }

    @Override
    public PlaceChapter chapter(Stage stage) throws IOException {
        return found.chapter(stage);
    }
}
