package org.dronewatch.buildings.io;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.setting.input.FileHash;

/**
 * The contents of a map file.
 *
 * @param features outlines of buildings, parts of buildings and woods, in the order of the file
 * @param model the buildings of a city model, with their walls and roofs; if present, there are no outlines
 * @param land land cover, if it was requested
 * @param leftOut number of features that could not be used, by what they are
 * @param format name of the file's format, for reports
 * @param system coordinate system of the file
 * @param hash hash of the file
 */
public record MapFeatures(
        List<MapFeature> features,
        Optional<CityModel> model,
        MapLand land,
        Map<String, Integer> leftOut,
        String format,
        MapSystem system,
        FileHash hash) {
    /** Copies the collections: later changes by the caller have no effect. */
    public MapFeatures {
        features = List.copyOf(features);
        leftOut = new LinkedHashMap<>(leftOut);
    }
}
