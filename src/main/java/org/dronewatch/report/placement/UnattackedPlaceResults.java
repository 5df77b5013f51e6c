package org.dronewatch.report.placement;

import java.io.IOException;
import org.dronewatch.placement.SolverLimits;
import org.dronewatch.placement.site.LeftOut;
import org.dronewatch.run.Stage;
import tools.jackson.databind.node.ObjectNode;

/**
 * What a search for placements found, without the attacks that were to be flown, which were omitted because of an
 * interruption or the time limit.
 *
 * @param found what the search found
 */
public record UnattackedPlaceResults(PlaceResults found) implements FoundPlaceResults {
    @Override
    public PlaceResults without(LeftOut part, SolverLimits limits) {
        return new UnattackedPlaceResults(found.without(part, limits));
    }

    @Override
    public boolean isInterrupted() {
        return !front().isWithout(LeftOut.ATTACKS);
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
