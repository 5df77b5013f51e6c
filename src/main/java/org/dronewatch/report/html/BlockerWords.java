package org.dronewatch.report.html;

import org.dronewatch.analysis.survey.Blocker;

/** The words for what blocks a line of sight. */
public final class BlockerWords {
    private BlockerWords() {}

    /** The name of a building on its map, or the file of the model; empty for a model without a file. */
    public static String name(Blocker blocker) {
        String file = blocker.obstacle().model().file();
        return blocker.building()
                .map(building -> building.name().map(name -> "'" + name + "'").orElse(building.id()))
                .orElse(file);
    }
}
