package org.dronewatch.geo;

import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.Limits;

/**
 * A point in plan by the name that a map gives it, as scene files may give it instead of a pair of east and north.
 *
 * @param feature name of a point in a GeoJSON or KML file
 * @param file that file; the one beside the scene file that has the same name but for {@code .geojson} or {@code .kml}
 *     unless given
 */
public record FeaturePoint(String feature, @FileName Optional<String> file) {
    /** Checks that there is a name. */
    public FeaturePoint {
        Limits.check(FeaturePoint.class, feature, file);
    }

    /** A point of the file with the scene's name. */
    @Defaults("feature")
    public static FeaturePoint of(String feature) {
        return new FeaturePoint(feature, Optional.empty());
    }
}
