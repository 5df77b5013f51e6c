package org.dronewatch.geo.features;

import java.util.Optional;
import tools.jackson.databind.JsonNode;

/**
 * What a GeoJSON file states about its coordinates. The current format (RFC 7946) allows longitude and latitude only;
 * the format of 2008 and its predecessor had a member {@code crs}, which most programs still write for grid
 * coordinates.
 */
public final class GeoJsonSystem {
    private GeoJsonSystem() {}

    /**
     * The name of the coordinate reference system in a file: a code, a URN or a URL, as it is written.
     *
     * @param root the whole file
     * @return empty if the file states none
     */
    public static Optional<String> stated(JsonNode root) {
        JsonNode crs = root.path("crs");
        JsonNode properties = crs.path("properties");
        String text =
                switch (crs.path("type").asString("")) {
                    case "name" -> properties.path("name").asString("");
                    case "EPSG" -> "EPSG:" + properties.path("code").asString("");
                    case "link" -> properties.path("href").asString("");
                    default -> "";
                };
        return Optional.of(text).filter(any -> !text.isBlank());
    }
}
