package org.dronewatch.report.map;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronewatch.run.SceneResult;
import org.dronewatch.run.Stage;

/**
 * A map of a run for map viewers: sensors, their fields of view, the flights, and the position of each drone when a
 * sensor detected or lost it. Longitude and latitude (WGS 84) are exact, in degrees; heights are in metres above sea
 * level, or above the scene's origin if the height of the origin is not known. The bytes depend only on the results.
 */
public final class SiteMap {
    /** The name of the GeoJSON file (RFC 7946). */
    public static final String GEO_JSON = "map.geojson";

    /** The name of the KML 2.2 file. */
    public static final String KML = "map.kml";

    /** The names of both files. */
    public static final List<String> FILES = List.of(GEO_JSON, KML);

    private final MapContent content;

    private SiteMap(MapContent content) {
        this.content = content;
    }

    /**
     * The map of a result's first run; empty unless the scene states the geographic position of its origin.
     *
     * @param stage the site of that run
     */
    public static Optional<SiteMap> of(SceneResult result, Stage stage) {
        return result.runs()
                .get(0)
                .settings()
                .world()
                .origin()
                .map(origin -> new SiteMap(new MapContent(result, stage, origin)));
    }

    /** Writes the map as GeoJSON. */
    public void writeGeoJson(Path file) throws IOException {
        new GeoJson(content).write(file);
    }

    /** Writes the map as KML. */
    public void writeKml(Path file) throws IOException {
        new Kml(content).write(file);
    }
}
