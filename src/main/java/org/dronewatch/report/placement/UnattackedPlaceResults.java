package org.dronewatch.report.placement;

import java.io.IOException;
import org.dronewatch.run.Stage;
import tools.jackson.databind.node.ObjectNode;

/**
 * What a search for placements found, without the attacks that were to be flown: an interruption has left them out.
 *
 * @param found by the search
 */
public record UnattackedPlaceResults(PlaceResults found) implements FoundPlaceResults {
    @Override
    public boolean isInterrupted() {
        return true;
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
