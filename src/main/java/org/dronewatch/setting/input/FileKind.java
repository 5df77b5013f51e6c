package org.dronewatch.setting.input;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiPredicate;

/**
 * The kind of a file that was named where a file of another kind is expected, recognised by its first characters or its
 * name.
 */
public enum FileKind {
    /** TIFF, which includes GeoTIFF. */
    TIFF("a TIFF file", "world.terrain", (name, start) -> start.matches("(?s)(II[*+]\0|MM\0[*+]).*")),
    /** An ESRI ASCII grid of elevations. */
    ASCII_GRID("an ESRI ASCII grid", "world.terrain", (name, start) -> start.matches("(?is)\\s*(ncols|nrows)\\s.*")),
    /** An SRTM tile, which has no signature at its beginning. */
    SRTM("an SRTM tile", "world.terrain", (name, start) -> name.endsWith(".hgt")),
    /** A building model in the STEP exchange format. */
    IFC("an IFC model", "world.models", (name, start) -> start.startsWith("ISO-10303-21")),
    /** glTF, as one binary file or as JSON. */
    GLTF("a glTF model", "world.models", (name, start) -> start.startsWith("glTF") || name.endsWith(".gltf")),
    /** Polygon file format. */
    PLY("a PLY model", "world.models", (name, start) -> start.matches("(?s)ply\\s.*")),
    /** STL, as text or in binary form; the latter has no fixed beginning. */
    STL("an STL model", "world.models", (name, start) -> start.matches("(?s)solid\\s.*") || name.endsWith(".stl")),
    /** Wavefront OBJ, which has no fixed beginning. */
    OBJ("an OBJ model", "world.models", (name, start) -> name.endsWith(".obj")),
    /** OpenStreetMap XML. */
    OSM("an OpenStreetMap extract", "world.buildings", (name, start) -> start.contains("<osm ")),
    /** OpenStreetMap data in the binary PBF format. */
    PBF("an OpenStreetMap extract", "world.buildings", (name, start) -> start.contains("OSMHeader")),
    /** GeoJSON and CityJSON. */
    JSON("a JSON file", "world.buildings", (name, start) -> start.matches("(?s)\\s*\\{.*"));

    private static final int BEGINNING = 200;

    private final String words;
    private final String place;
    private final BiPredicate<String, String> signature;

    FileKind(String words, String place, BiPredicate<String, String> signature) {
        this.words = words;
        this.place = place;
        this.signature = signature;
    }

    /**
     * What is wrong with a file that its reader does not recognise, as the end of a message.
     *
     * @param name name of the file
     * @param start the first bytes of the file, of which at most 200 are used
     * @param wanted the setting under which the file was named: world.terrain, world.models or world.buildings
     * @return what is wrong; empty if the kind of the file cannot be determined, or if the file belongs there
     */
    public static Optional<String> misplaced(String name, byte[] start, String wanted) {
        if (start.length == 0) {
            return Optional.of("is empty");
        }
        // One character for each byte.
        String text = new String(start, 0, Math.min(BEGINNING, start.length), StandardCharsets.ISO_8859_1);
        String lower = name.toLowerCase(Locale.ROOT);
        return Arrays.stream(values())
                .filter(kind -> kind.signature.test(lower, text))
                .findFirst()
                .filter(kind -> !kind.place.equals(wanted))
                .map(kind -> "is " + kind.words + ", which belongs under " + kind.place + ", not under " + wanted);
    }
}
