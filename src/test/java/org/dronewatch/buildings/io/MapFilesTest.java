package org.dronewatch.buildings.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.dronewatch.Thorough;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The same outlines from each format, and one line for what is damaged, hostile or something else. */
class MapFilesTest {
    private static final MapArea ANYWHERE = new MapArea(-180, 180, -90, 90);
    private static final Path MONACO = Path.of("sites/monaco.osm.gz");

    private static final String NODES =
            """
            <node id='1' lat='50' lon='15'/><node id='2' lat='50' lon='15.001'/>
            <node id='3' lat='50.001' lon='15.001'/><node id='4' lat='50.001' lon='15'/>
            <node id='5' lat='50.0004' lon='15.0004'/><node id='6' lat='50.0004' lon='15.0006'/>
            <node id='7' lat='50.0006' lon='15.0005'><tag k='building' v='yes'/></node>
            """;

    private static final String WAYS =
            """
            <way id='11'><nd ref='1'/><nd ref='2'/><nd ref='3'/></way>
            <way id='12'><nd ref='1'/><nd ref='4'/><nd ref='3'/></way>
            <way id='13'><nd ref='5'/><nd ref='6'/><nd ref='7'/><nd ref='5'/><tag k='building' v='yes'/></way>
            <way id='14'><nd ref='1'/><nd ref='2'/><tag k='building' v='yes'/></way>
            <way id='15' visible='false'><nd ref='5'/><nd ref='6'/><nd ref='7'/><nd ref='5'/><tag k='building' v='no'/></way>
            """;

    private static final String RELATION =
            """
            <relation id='21'><member type='way' ref='11' role='outer'/><member type='way' ref='12' role='outer'/>
              <member type='way' ref='13' role='inner'/><member type='node' ref='5' role='entrance'/>
              <tag k='type' v='multipolygon'/><tag k='building' v='hall'/><tag k='height' v='12'/></relation>
            """;

    @TempDir
    private Path directory;

    private MapFeatures read(byte[] bytes) throws IOException {
        Files.write(directory.resolve("map"), bytes);
        return new MapFiles(directory).read("map", ANYWHERE);
    }

    /** With what covers the ground. */
    private MapFeatures readAll(byte[] bytes) throws IOException {
        Files.write(directory.resolve("map"), bytes);
        return new MapFiles(directory).read("map", ANYWHERE, true);
    }

    private MapFeatures read(String text) throws IOException {
        return read(text.getBytes(StandardCharsets.UTF_8));
    }

    private static List<String> inWords(MapFeatures map) {
        return map.features().stream()
                .map(one -> one.id() + " "
                        + one.outers().stream().map(Arrays::toString).toList() + " "
                        + one.inners().stream().map(Arrays::toString).toList() + " " + new TreeMap<>(one.tags()))
                .toList();
    }

    @Test
    void waysAreJoinedAndCourtyardsKept() throws IOException {
        MapFeatures map = read("<osm>" + NODES + WAYS + RELATION + "</osm>");

        assertThat(map.format()).isEqualTo("OpenStreetMap XML");
        assertThat(inWords(map))
                .containsExactly(
                        "relation/21 [[15.0, 50.0, 15.0, 50.001, 15.001, 50.001, 15.001, 50.0]] [[15.0004, 50.0004, 15.0006,"
                                + " 50.0004, 15.0005, 50.0006]] {building=hall, height=12, type=multipolygon}",
                        "way/13 [[15.0004, 50.0004, 15.0006, 50.0004, 15.0005, 50.0006]] [] {building=yes}");
        assertThat(map.leftOut()).isEqualTo(Map.of("point", 1, "outline not closed", 1));
    }

    /** Overpass writes ways before their nodes, and a byte order mark or spaces may come first. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "<osm>%2$s%3$s%1$s</osm>",
                "<osm>%3$s%2$s%1$s</osm>",
                "\uFEFF<?xml version='1.0'?>\n<osm>%1$s%2$s%3$s</osm>"
            })
    void theOrderOfElementsDoesNotMatter(String order) throws IOException {
        assertThat(inWords(read(String.format(order, NODES, WAYS, RELATION))))
                .isEqualTo(inWords(read("<osm>" + NODES + WAYS + RELATION + "</osm>")));
    }

    /** A file whose first nodes come before the ways, and others after them. */
    @Test
    void nodesThatComeLateAreNotLost() throws IOException {
        String[] halves = NODES.split("(?=<node id='3')");
        assertThat(inWords(read("<osm>" + halves[0] + WAYS + RELATION + halves[1] + "</osm>")))
                .hasSize(2);
    }

    @Test
    void whatIsElsewhereIsDropped() throws IOException {
        Files.writeString(directory.resolve("map"), "<osm>" + NODES + WAYS + RELATION + "</osm>");
        assertThat(new MapFiles(directory)
                        .read("map", new MapArea(14, 14.9, 49, 51))
                        .features())
                .isEmpty();
        assertThat(new MapArea(179, 181, -1, 1).contains(-179.5, 0)).isTrue();
        assertThat(new MapArea(179, 181, -1, 1).contains(178.5, 0)).isFalse();
    }

    /** Monaco in the binary format, by a writer of its own, gives the same as in XML. */
    @Test
    void bothFormatsOfOpenStreetMapGiveTheSame() throws IOException {
        MapFeatures xml;
        try (InputStream in = Files.newInputStream(MONACO)) {
            xml = read(in.readAllBytes());
        }
        byte[] pbf = pbf(true);
        MapFeatures binary = read(pbf);

        assertThat(binary.format()).isEqualTo("OpenStreetMap PBF");
        assertThat(inWords(binary)).isEqualTo(inWords(xml)).hasSize(966);
        assertThat(inWords(read(pbf(false)))).isEqualTo(inWords(xml));
    }

    /** The land cover of Monaco, too, whose buildings are the same with it. */
    @Thorough
    @Test
    void bothFormatsGiveTheSameLandCover() throws IOException {
        MapFeatures xml = readAll(Files.readAllBytes(MONACO));
        MapFeatures binary = readAll(pbf(true));

        assertThat(inWords(xml)).hasSize(966);
        assertThat(xml.land().shapes())
                .hasSizeGreaterThan(800)
                .usingRecursiveComparison()
                .isEqualTo(binary.land().shapes());
        assertThat(xml.land().shapes().stream()
                        .filter(shape -> "coastline".equals(shape.tags().get("natural"))))
                .hasSize(17);
    }

    private static byte[] pbf(boolean isDense) throws IOException {
        PbfWriter writer = new PbfWriter(isDense);
        try (InputStream in = new GZIPInputStream(Files.newInputStream(MONACO))) {
            OsmXml.read("monaco", in, writer);
        }
        return writer.bytes();
    }

    @Test
    void geoJsonHasPolygonsWithProperties() throws IOException {
        MapFeatures map = read(
                """
                {"type": "FeatureCollection", "features": [
                  {"type": "Feature", "id": "hall", "properties": {"height": 12.5, "levels": null, "name": "Hall"},
                   "geometry": {"type": "Polygon", "coordinates": [[[15,50],[15.001,50],[15.001,50.001],[15,50]],
                     [[15.0005,50.0002],[15.0008,50.0002],[15.0008,50.0004],[15.0005,50.0002]]]}},
                  {"type": "Feature", "properties": {"building": "no"},
                   "geometry": {"type": "Polygon", "coordinates": [[[0,0],[1,0],[1,1],[0,0]]]}},
                  {"type": "Feature", "properties": null, "geometry": {"type": "MultiPolygon", "coordinates":
                     [[[[1,1],[2,1],[2,2],[1,1]]], [[[3,3,7],[4,3,7],[4,4,7],[3,3,7]]]]}},
                  {"type": "Feature", "geometry": {"type": "Point", "coordinates": [1,2]}},
                  {"type": "Feature", "geometry": null}]}
                """);
        assertThat(inWords(map))
                .containsExactly(
                        "hall [[15.0, 50.0, 15.001, 50.0, 15.001, 50.001]] [[15.0005, 50.0002, 15.0008, 50.0002, 15.0008,"
                                + " 50.0004]] {height=12.5, name=Hall}",
                        "feature/2 [[1.0, 1.0, 2.0, 1.0, 2.0, 2.0]] [] {}",
                        "feature/2 [[3.0, 3.0, 4.0, 3.0, 4.0, 4.0]] [] {}");
        assertThat(map.leftOut()).isEqualTo(Map.of("Point", 1, "feature without a geometry", 1));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            quoteCharacter = '~',
            value = {
                "<kml/> | map: begins with <kml> but must begin with <osm>: not an OpenStreetMap file",
                "<osm><node id='x' lat='1' lon='1'/></osm> | map:1: <node> id='x' must be a whole number",
                "<osm><node id='1' lon='1'/></osm> | map:1: <node> lat is missing; it must be a number",
                "<osm><node id='1' lat='91' lon='1'/></osm> | map:1: <node> lat='91' must be -90.0 to 90.0",
                "<osm><node id='1' lat='NaN' lon='1'/></osm> | map:1: <node> lat='NaN' must be -90.0 to 90.0",
                "{\"type\": \"Topology\"} | map: 'type' is 'Topology' but must be FeatureCollection or CityJSON: not a map with areas",
                "{\"type\": \"Polygon\", \"coordinates\": [[[1]]]} | map: geometry: corner 0 of an outline is [1] but must be numbers:"
                        + " [longitude, latitude]",
                "hello | map: is not OpenStreetMap XML, OpenStreetMap PBF, GeoJSON or CityJSON; 'ogr2ogr buildings.geojson map'"
                        + " converts most other formats",
            })
    void whatIsWrongIsNamed(String text, String message) {
        assertThatThrownBy(() -> read(text)).isInstanceOf(InputException.class).hasMessage(message);
    }

    @Test
    void noEntityIsExpandedAndNoOtherFileRead() {
        assertThatThrownBy(() -> read("<!DOCTYPE osm [<!ENTITY a SYSTEM 'file:///etc/hostname'>]><osm>&a;</osm>"))
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith("map:1: not well-formed XML: ")
                .hasMessageNotContaining("\n");
    }

    @Test
    void nestingWithoutEndIsRefused() {
        assertThatThrownBy(() -> read("{\"type\":\"GeometryCollection\",\"geometries\":[".repeat(5000)))
                .isInstanceOf(InputException.class);
        String deep = "{\"type\":\"GeometryCollection\",\"geometries\":[".repeat(70) + "]}".repeat(70);
        assertThatThrownBy(() -> read(deep))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("nested more than");
    }

    /** Cut off anywhere, or with a few bits flipped, a file gives features or one line. */
    @Test
    void damagedFilesGiveOneLine() throws IOException {
        long seed = 20261124L;
        Random random = new Random(seed);
        String xml = "<osm>" + NODES + WAYS + RELATION
                + (WAYS + RELATION).replace("building", "landuse").replace("id='", "id='9") + "</osm>";
        PbfWriter writer = new PbfWriter(true);
        OsmXml.read("map", new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), writer);
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (GZIPOutputStream zip = new GZIPOutputStream(packed)) {
            zip.write(xml.getBytes(StandardCharsets.UTF_8));
        }
        for (byte[] whole : List.of(writer.bytes(), packed.toByteArray(), xml.getBytes(StandardCharsets.UTF_8))) {
            for (int i = 0; i < 400; i++) {
                byte[] damaged = i % 2 == 0 ? Arrays.copyOf(whole, random.nextInt(whole.length)) : whole.clone();
                for (int flips = i % 2 == 0 ? 0 : 1 + random.nextInt(3); flips > 0; flips--) {
                    damaged[random.nextInt(damaged.length)] ^= (byte) (1 << random.nextInt(8));
                }
                try {
                    readAll(damaged);
                } catch (InputException e) {
                    assertThat(e.getMessage())
                            .as("seed %d, case %d", seed, i)
                            .doesNotContain("\n")
                            .startsWith("map");
                }
            }
        }
    }

    /** A block that states 2 GB, one that unpacks to more than it states, and numbers of texts that are not there. */
    @Test
    void blocksThatLieAreRefused() throws IOException {
        byte[] huge = PbfWriter.header("OSMHeader", 0x7FFFFFFF);
        assertThatThrownBy(() -> read(huge))
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith("map: cannot be read: a block has 2147483647 bytes but must have at most ");
        byte[] bomb = PbfWriter.blob("OSMHeader", new byte[1 << 20], 10);
        assertThatThrownBy(() -> read(bomb))
                .isInstanceOf(InputException.class)
                .hasMessage("map: cannot be read: a block unpacks to more than the 10 bytes that it states");
        assertThatThrownBy(() -> read(PbfWriter.blob("OSMHeader", PbfWriter.text(4, "LocationsOnWays"), -1)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("requires a reader with the feature 'LocationsOnWays'");
    }

    @Test
    void aMissingFileIsNamed() {
        assertThatThrownBy(() -> new MapFiles(directory).read("none.osm", ANYWHERE))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("none.osm: no such file");
    }
}
