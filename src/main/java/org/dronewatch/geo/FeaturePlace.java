package org.dronewatch.geo;

import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A place given by its name in a map file; scene files can state it instead of a position:
 * {@code {feature: north gate, above: 3 m}}. Without {@code above} and {@code height}, it has the height in the file
 * or, if the file states none, lies on the highest surface there.
 *
 * @param feature name of a point in a GeoJSON or KML file
 * @param file the GeoJSON or KML file; by default the one next to the scene file, with the same name but ending in
 *     {@code .geojson} or {@code .kml}
 * @param above height above the highest surface there (ground, roof or tree), 0 to 100,000, m
 * @param height height above sea level, measured from the same level as the height of the origin, -100,000 to
 *     100,000, m
 */
public record FeaturePlace(
        String feature,
        @FileName Optional<String> file,
        @In(value = Quantity.LENGTH, from = 0, to = In.FARTHEST) Optional<Double> above,
        @In(value = Quantity.LENGTH, from = -In.FARTHEST, to = In.FARTHEST) Optional<Double> height) {
    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range, or there are two heights
     */
    public FeaturePlace {
        Limits.check(FeaturePlace.class, feature, file, above, height);
        if (above.isPresent() && height.isPresent()) {
            throw new IllegalArgumentException("above and height are mutually exclusive: omit one of them");
        }
    }

    /** A place in the file with the scene's name. */
    @Defaults("feature")
    public static FeaturePlace of(String feature) {
        return new FeaturePlace(feature, Optional.empty(), Optional.empty(), Optional.empty());
    }
}
