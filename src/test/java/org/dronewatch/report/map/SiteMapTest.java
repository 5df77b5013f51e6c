package org.dronewatch.report.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import com.networknt.schema.InputFormat;
import com.networknt.schema.Schema;
import com.networknt.schema.SchemaRegistry;
import com.networknt.schema.SpecificationVersion;
import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import javax.xml.parsers.DocumentBuilderFactory;
import org.dronewatch.geo.Origin;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.io.geojson.GeoJsonReader;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import org.xml.sax.SAXException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

class SiteMapTest {
    private static final JsonMapper JSON = JsonMapper.builder().build();
    private static final String ODD = "A <\"meadow\"> & 'more' \u00e4\ud83d\ude81]]>";

    @TempDir
    private static Path directory;

    private static SceneResult result;
    private static Path geoJson;
    private static Path kml;

    @BeforeAll
    static void run() throws IOException {
        result = Meadow.somewhere(directory).run();
        geoJson = directory.resolve("map.geojson");
        kml = directory.resolve("map.kml");
        write(new SceneRunner(Meadow.somewhere(directory)), geoJson, kml);
    }

    /** The map of a scene's run. */
    private static Optional<SiteMap> map(SceneRunner runner) {
        SceneResult finished = runner.run();
        return SiteMap.of(finished, runner.stage(finished.runs().get(0).settings()));
    }

    private static void write(SceneRunner scene, Path geoJson, Path kml) throws IOException {
        SiteMap map = map(scene).orElseThrow();
        map.writeGeoJson(geoJson);
        map.writeKml(kml);
    }

    static Schema schema() throws IOException {
        try (InputStream stream = SiteMapTest.class.getResourceAsStream("geojson.schema.json")) {
            return SchemaRegistry.withDefaultDialect(SpecificationVersion.DRAFT_2020_12)
                    .getSchema(new String(stream.readAllBytes(), StandardCharsets.UTF_8), InputFormat.JSON);
        }
    }

    private static List<JsonNode> features(Path file) throws IOException {
        List<JsonNode> features = new ArrayList<>();
        JSON.readTree(Files.readString(file)).get("features").forEach(features::add);
        return features;
    }

    private static List<JsonNode> features(String folder) throws IOException {
        return features(geoJson).stream()
                .filter(feature ->
                        feature.get("properties").get("folder").asString().equals(folder))
                .toList();
    }

    private static JsonNode feature(String name) throws IOException {
        return features(geoJson).stream()
                .filter(feature ->
                        feature.get("properties").get("name").asString().equals(name))
                .findFirst()
                .orElseThrow();
    }

    private static Document parsed(Path file) throws Exception {
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        factory.setNamespaceAware(true);
        return factory.newDocumentBuilder().parse(file.toFile());
    }

    private static List<String> texts(Document document, String tag) {
        List<String> texts = new ArrayList<>();
        NodeList nodes = document.getElementsByTagNameNS("*", tag);
        for (int i = 0; i < nodes.getLength(); i++) {
            texts.add(nodes.item(i).getTextContent());
        }
        return texts;
    }

    @Test
    void geoJsonIsAsItsStandardWantsIt() throws IOException {
        assertThat(schema().validate(Files.readString(geoJson), InputFormat.JSON))
                .isEmpty();
        // The schema does find mistakes.
        for (String mistake : List.of("\"Point\"", "\"Feature\"", "\"coordinates\"", "\"FeatureCollection\"")) {
            String broken = Files.readString(geoJson).replace(mistake, "\"Pint\"");
            assertThat(schema().validate(broken, InputFormat.JSON)).as(mistake).isNotEmpty();
        }
    }

    /** By another reader, and by its notion of an area that is one. */
    @Test
    void areasAreClosedAndTurnTheRightWay() throws Exception {
        int areas = 0;
        int holes = 0;
        for (JsonNode feature : features(geoJson)) {
            Geometry geometry = new GeoJsonReader().read(feature.get("geometry").toString());
            assertThat(geometry.isValid()).as(feature.toString()).isTrue();
            if (geometry instanceof Polygon polygon) {
                areas++;
                assertThat(polygon.getExteriorRing().isClosed()).isTrue();
                assertThat(Orientation.isCCW(polygon.getExteriorRing().getCoordinateSequence()))
                        .isTrue();
                for (int hole = 0; hole < polygon.getNumInteriorRing(); hole++, holes++) {
                    assertThat(Orientation.isCCW(polygon.getInteriorRingN(hole).getCoordinateSequence()))
                            .isFalse();
                }
            }
        }
        assertThat(areas).isEqualTo(5);
        assertThat(holes).isEqualTo(1);
    }

    @Test
    void aMapHoldsSensorsFieldsFlightsAndDetections() throws IOException {
        assertThat(features("Sensors")).hasSize(5);
        assertThat(features("Fields of view")).hasSize(4);
        assertThat(features("Flights")).hasSize(2);
        JsonNode zone = feature("protected");
        assertThat(zone.get("properties").get("radius_m").asDouble()).isEqualTo(25.0);
        assertThat(zone.get("geometry").get("type").asString()).isEqualTo("Polygon");
        JsonNode alert = feature("alert for visitor").get("properties");
        assertThat(alert.get("time_s").asDouble())
                .isEqualTo(result.alert("visitor").time().orElseThrow(), within(1e-6));
        assertThat(alert.get("sensors").asString())
                .isEqualTo(String.join(", ", result.alert("visitor").sensors()));
        assertThat(features("Detections"))
                .hasSize(result.runs().get(0).events().size())
                .hasSizeGreaterThan(3);
        JsonNode eye = feature("eye").get("properties");
        assertThat(eye.get("kind").asString()).isEqualTo("camera");
        assertThat(eye.get("height_m").asDouble()).isEqualTo(2.0);
        assertThat(eye.get("range_m_visitor").asDouble())
                .isEqualTo(result.firstDetectionRange("eye", "visitor").orElseThrow(), within(1e-6));
        assertThat(eye.get("first_detected_s_visitor").asDouble()).isPositive();
        assertThat(eye.get("first_detected_s_kite").isNull()).isTrue();
        assertThat(eye.get("marker-color").asString()).isEqualTo("#1f5fbf");
        assertThat(feature("field of view of eye").get("properties").get("fill").asString())
                .isEqualTo("#1f5fbf");
        assertThat(feature("flight of visitor").get("geometry").get("coordinates"))
                .hasSizeBetween(100, 301);
        assertThat(feature("flight of kite").get("geometry").get("type").asString())
                .isEqualTo("Point");
        assertThat(Files.readString(geoJson)).doesNotContain("http", "NaN", "Infinity");
    }

    @Test
    void aDroneLandsWhereItShould() throws IOException {
        JsonNode place = feature("flight of kite").get("geometry").get("coordinates");
        assertThat(place.get(0).asDouble()).isEqualTo(10.01, within(2e-6));
        assertThat(place.get(1).asDouble()).isEqualTo(45.01, within(2e-6));
        assertThat(place.get(2).asDouble()).isEqualTo(60.0);

        // It comes straight from the north; 111132 m are a degree.
        JsonNode first =
                feature("flight of visitor").get("geometry").get("coordinates").get(0);
        assertThat(first.get(0).asDouble()).isEqualTo(10.0);
        assertThat(first.get(1).asDouble()).isEqualTo(45.0 + 160.0 / 111_132.0, within(1e-7));
        assertThat(first.get(2).asDouble()).isEqualTo(30.0);
    }

    /** In their own folder, in a colour that no drone has, and without 'drone' among the properties. */
    @Test
    void birdsAreDrawnApartFromDrones() throws Exception {
        Path map = directory.resolve("birds.geojson");
        Path folders = directory.resolve("birds.kml");
        write(
                new SceneRunner(Meadow.somewhere(directory))
                        .set("drones.kite.radio.control", "autonomous")
                        .set("drones.kite.soundLevel", "0")
                        .set("drones.kite.soundPowerLevel", "0")
                        .set("drones.kite.label.role", "bird")
                        .set("run.duration", "0.1"),
                map,
                folders);
        JsonNode bird = features(map).stream()
                .map(feature -> feature.get("properties"))
                .filter(feature -> feature.get("name").asString().equals("flight of kite (bird)"))
                .findFirst()
                .orElseThrow();
        assertThat(bird.get("folder").asString()).isEqualTo("Birds");
        assertThat(bird.get("bird").asString()).isEqualTo("kite");
        assertThat(bird.has("drone")).isFalse();
        assertThat(bird.get("marker-color").asString()).isEqualTo("#6b7280");
        assertThat(texts(parsed(folders), "name")).containsSubsequence("Flights", "flight of visitor", "Birds");
        new KmlSchema().validate(folders);
        assertThat(Files.readString(kml)).doesNotContain("Birds");
    }

    @Test
    void aDetectionIsWhereTheDroneWas() throws IOException {
        JsonNode gained = feature("eye detects visitor");
        double time = gained.get("properties").get("time_s").asDouble();
        double way = Math.hypot(155, 26);
        assertThat(gained.get("geometry").get("coordinates").get(1).asDouble())
                .isEqualTo(45.0 + (160.0 - 20.0 * time * 155.0 / way) / 111_132.0, within(1e-7));
        assertThat(gained.get("properties").get("height_m").asDouble())
                .isEqualTo(30.0 - 20.0 * time * 26.0 / way, within(1e-6));
        assertThat(gained.get("properties").get("threshold").asDouble()).isEqualTo(12.0);
        assertThat(gained.get("properties").get("unit").asString()).isEqualTo("px");
        // Nearer than its least range, the radar has no reading.
        JsonNode lost = feature("dish loses visitor").get("properties");
        assertThat(lost.get("value").isNull()).isTrue();
        assertThat(lost.get("marker-size").asString()).isEqualTo("small");
    }

    @Test
    void kmlIsAsItsSchemaWantsIt() throws Exception {
        KmlSchema schema = new KmlSchema();
        schema.validate(kml);
        for (String mistake : List.of("Placemark", "clampToGround", "ExtendedData", "outerBoundaryIs", "scale")) {
            Path broken = directory.resolve("broken.kml");
            Files.writeString(broken, Files.readString(kml).replace(mistake, "wrong"));
            assertThatThrownBy(() -> schema.validate(broken)).as(mistake).isInstanceOf(SAXException.class);
        }
    }

    @Test
    void kmlShowsTheSameAsGeoJson() throws Exception {
        Document document = parsed(kml);
        Element root = document.getDocumentElement();
        assertThat(root.getNamespaceURI()).isEqualTo("http://www.opengis.net/kml/2.2");
        List<String> expected = new ArrayList<>(List.of("meadow"));
        for (String folder :
                List.of("Sensors", "Fields of view", "Protected zones", "Flights", "Alerts", "Detections")) {
            expected.add(folder);
            for (JsonNode feature : features(folder)) {
                expected.add(feature.get("properties").get("name").asString());
            }
        }
        assertThat(texts(document, "name")).isEqualTo(expected);
        assertThat(texts(document, "description"))
                .hasSize(1)
                .first()
                .asString()
                .contains("altitude of the origin is unknown");
        assertThat(Files.readString(kml).replace("http://www.opengis.net/kml/2.2", ""))
                .doesNotContain("http", "NaN", "Infinity");
        // Opacity, blue, green, red.
        assertThat(texts(document, "color")).contains("ff006aff", "26006aff");
        for (String coordinates : texts(document, "coordinates")) {
            assertThat(coordinates)
                    .matches("(10|9\\.\\d+|10\\.\\d+),(45|44\\.\\d+|45\\.\\d+)(,-?[\\d.]+)?("
                            + " [-\\d.]+,[-\\d.]+(,[-\\d.]+)?)*");
        }
    }

    @Test
    void theSameResultsGiveTheSameBytes() throws IOException {
        Path again = directory.resolve("again.geojson");
        Path kmlAgain = directory.resolve("again.kml");
        write(new SceneRunner(Meadow.somewhere(directory)).threads(3), again, kmlAgain);

        assertThat(Files.readString(again)).isEqualTo(Files.readString(geoJson));
        assertThat(Files.readString(kmlAgain)).isEqualTo(Files.readString(kml));
    }

    @Test
    void oddNamesAreEscaped() throws Exception {
        Origin origin = Origin.at(-0.3, -3);
        Path odd = directory.resolve("odd.geojson");
        Path oddKml = directory.resolve("odd.kml");
        write(new SceneRunner(new Meadow(directory, ODD + "\u0001\ud800", Optional.of(origin))), odd, oddKml);

        assertThat(JSON.readTree(Files.readString(odd)).get("name").asString()).startsWith(ODD + "\u0001");
        assertThat(schema().validate(Files.readString(odd), InputFormat.JSON)).isEmpty();
        new KmlSchema().validate(oddKml);
        assertThat(texts(parsed(oddKml), "name").get(0)).isEqualTo(ODD + "\ufffd\ufffd");
    }

    @Test
    void areasStayInOnePieceAcrossTheDateLine() throws Exception {
        Origin origin = Origin.at(Math.toRadians(-17), Math.PI);
        Path file = directory.resolve("fiji.geojson");
        write(new SceneRunner(new Meadow(directory, "fiji", Optional.of(origin))), file, directory.resolve("fiji.kml"));

        int areas = 0;
        for (JsonNode feature : features(file)) {
            Geometry geometry = new GeoJsonReader().read(feature.get("geometry").toString());
            assertThat(geometry.isValid()).isTrue();
            // 10 km to both sides are a fifth of a degree.
            assertThat(geometry.getEnvelopeInternal().getWidth()).isLessThan(0.2);
            areas += geometry instanceof Polygon ? 1 : 0;
        }
        assertThat(areas).isEqualTo(5);
        new KmlSchema().validate(directory.resolve("fiji.kml"));
    }

    @Test
    void withTheHeightOfTheOriginDronesAreInTheAir() throws Exception {
        Origin origin = Origin.at(Math.toRadians(45), Math.toRadians(10)).withHeight(430.0);
        Path file = directory.resolve("high.kml");
        write(
                new SceneRunner(new Meadow(directory, "high", Optional.of(origin))),
                directory.resolve("high.geojson"),
                file);

        new KmlSchema().validate(file);
        assertThat(schema().validate(Files.readString(directory.resolve("high.geojson")), InputFormat.JSON))
                .isEmpty();
        String text = Files.readString(file);
        assertThat(text).contains("<altitudeMode>absolute</altitudeMode>", "<extrude>1</extrude>", "above sea level");
        // The visitor comes from 30 m above the origin, 160 m to the north.
        double first = features(directory.resolve("high.geojson")).stream()
                .filter(feature ->
                        feature.get("properties").get("name").asString().equals("flight of visitor"))
                .findFirst()
                .orElseThrow()
                .get("geometry")
                .get("coordinates")
                .get(0)
                .get(2)
                .asDouble();
        assertThat(first).isEqualTo(460.0);
    }

    @Test
    void withoutAnOriginThereIsNoMap() {
        assertThat(map(new SceneRunner(new Meadow(directory, "nowhere", Optional.empty()))))
                .isEmpty();
    }
}
