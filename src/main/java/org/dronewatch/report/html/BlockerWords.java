package org.dronewatch.report.html;

import org.dronewatch.analysis.survey.Blocker;
import org.dronewatch.mesh.io.ModelRole;

/** The words for what blocks a line of sight. */
public final class BlockerWords {
    private BlockerWords() {}

    /**
     * The name of a building in quotation marks, or its identifier on the map; for anything else, the file of the
     * model, empty for a model without a file.
     */
    public static String name(Blocker blocker) {
        String file = blocker.obstacle().model().file();
        return blocker.building()
                .map(building -> building.name().map(name -> "'" + name + "'").orElse(building.id()))
                .orElse(file);
    }

    /** What a sensor stands on: {@code the ground}, {@code 'reactor hall'}, {@code building way/123}, {@code trees}. */
    public static String footing(Blocker below) {
        ModelRole role = below.obstacle().model().role();
        String name = name(below);
        return switch (role) {
            case TERRAIN -> "the ground";
            case VEGETATION -> "trees";
            case BUILDING, OTHER ->
                name.isBlank()
                        ? "a model"
                        : below.building().isPresent() && !name.startsWith("'") ? "building " + name : name;
        };
    }
}
