package org.dronewatch.geo;

import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.Limits;

/**
 * A point in plan view, given by its name in a map file; scene files can state it instead of a pair of east and north
 * coordinates.
 *
 * @param feature name of a point in a GeoJSON or KML file
 * @param file the GeoJSON or KML file; by default the one next to the scene file, with the same name but ending in
 *     {@code .geojson} or {@code .kml}
 */
public record FeaturePoint(String feature, @FileName Optional<String> file) {
    /** Checks that there is a name. */
    public FeaturePoint {
        Limits.check(FeaturePoint.class, feature, file);
    }

    /** A point in the file with the scene's name. */
    @Defaults("feature")
    public static FeaturePoint of(String feature) {
        return new FeaturePoint(feature, Optional.empty());
    }
}
