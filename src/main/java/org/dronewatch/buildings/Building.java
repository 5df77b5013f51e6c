package org.dronewatch.buildings;

import java.util.Map;

/**
 * A building, or a part of one, on the plane of the world frame.
 *
 * @param id identifier of the building on the map
 * @param footprint its outline
 * @param tags what the map states about it
 * @param isPart whether this is a part of a building; parts replace the outline to which they belong
 */
record Building(String id, Footprint footprint, Map<String, String> tags, boolean isPart) {
    /** Whether no part of it is above the ground. */
    boolean isUnderground() {
        return "underground".equals(tags.get("location"));
    }
}
