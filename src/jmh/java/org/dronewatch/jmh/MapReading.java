package org.dronewatch.jmh;

import java.nio.file.Path;
import org.dronewatch.buildings.io.MapArea;
import org.dronewatch.buildings.io.MapFeatures;
import org.dronewatch.buildings.io.MapFiles;
import org.dronewatch.geo.Origin;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.State;

/**
 * Reads the buildings and woods of a map in a fresh JVM, on one thread. Another map is named on the command line:
 * {@code MapReading -p map=/tmp/andorra.osm.pbf -p latitude=42.55 -p longitude=1.55}.
 */
@State(Scope.Benchmark)
public class MapReading extends FreshJvm {
    /** Path of the map. */
    @Param("sites/monaco.osm.gz")
    public String map;

    /** Latitude of the origin, about which features are kept, degrees. */
    @Param("43.7314")
    public double latitude;

    /** Longitude of the origin, degrees. */
    @Param("7.4202")
    public double longitude;

    /** Distance from the origin within which features are kept, m. */
    @Param("100000")
    public double radius;

    /** Reads the map, as a scene does. */
    @Benchmark
    public MapFeatures read() {
        Origin origin = Origin.at(Math.toRadians(latitude), Math.toRadians(longitude));
        return new MapFiles(Path.of("")).read(map, MapArea.about(origin, radius));
    }
}
