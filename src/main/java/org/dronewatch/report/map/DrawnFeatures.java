package org.dronewatch.report.map;

import java.util.List;

/** What a map for map viewers shows. */
interface DrawnFeatures {
    /** The title of the map. */
    String title();

    /** A description of the map and its height reference. */
    String description();

    /** The features, in the order in which they are drawn. */
    List<StyledFeature> features();

    /** The titles of the folders, in their order. */
    List<String> folders();

    /** Whether heights above the sea are known, so that features in the air can be drawn at their heights. */
    boolean isInSpace();
}
