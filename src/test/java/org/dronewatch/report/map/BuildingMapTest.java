package org.dronewatch.report.map;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.locationtech.jts.algorithm.Orientation;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.Polygon;
import org.locationtech.jts.io.ParseException;
import org.locationtech.jts.io.geojson.GeoJsonReader;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Outlines of buildings in the maps of a run are those of the map that the buildings came from. */
class BuildingMapTest {
    /**
     * A hall of known height, a block with a courtyard of unknown height, and a bridge between them, far from the
     * origin.
     */
    private static final String OSM = "<osm version='0.6'>"
            + node(1, "50.0100", "15.0200") + node(2, "50.0100", "15.0204")
            + node(3, "50.0102", "15.0204") + node(4, "50.0102", "15.0200")
            + node(5, "50.0104", "15.0200") + node(6, "50.0104", "15.0206")
            + node(7, "50.0108", "15.0206") + node(8, "50.0108", "15.0200")
            + node(9, "50.0105", "15.0202") + node(10, "50.0105", "15.0204")
            + node(11, "50.0107", "15.0204") + node(12, "50.0107", "15.0202")
            + node(13, "50.0102", "15.0201") + node(14, "50.0102", "15.0202")
            + node(15, "50.0104", "15.0202") + node(16, "50.0104", "15.0201")
            + "<way id='100'><nd ref='1'/><nd ref='2'/><nd ref='3'/><nd ref='4'/><nd ref='1'/>"
            + "<tag k='building' v='yes'/><tag k='height' v='12.5'/><tag k='name' v='Hall &lt;A&gt;'/></way>"
            + "<way id='101'><nd ref='5'/><nd ref='6'/><nd ref='7'/><nd ref='8'/><nd ref='5'/></way>"
            + "<way id='102'><nd ref='9'/><nd ref='10'/><nd ref='11'/><nd ref='12'/><nd ref='9'/></way>"
            + "<way id='103'><nd ref='13'/><nd ref='14'/><nd ref='15'/><nd ref='16'/><nd ref='13'/>"
            + "<tag k='building' v='bridge'/><tag k='height' v='9'/><tag k='min_height' v='6'/></way>"
            + "<relation id='104'><member type='way' ref='101' role='outer'/><member type='way' ref='102' role='inner'/>"
            + "<tag k='type' v='multipolygon'/><tag k='building' v='yes'/></relation></osm>";

    private static final String SCENE =
            """
            world:
              origin: {latitude: 50 deg, longitude: 15 deg, height: 300 m}
              buildings: {file: town.osm, height: 7 m}
              models: [{file: ground.obj, upAxis: z, role: terrain}]
            drones:
              one: {model: packaged:quadrotor.obj, flight: {kind: hover, position: [0, 0, 50]}}
            sensors:
              box: {kind: rf, position: [0, 0, 2]}
            alert:
              zones:
                yard: {area: [[0, 0], [0, 50], [80, 50], [80, 0]], floor: 5 m, height: 40 m}
                hall: {centre: [1440, 1110], radius: 100 m, height: 30 m}
            run: {duration: 1 s}
            """;

    @TempDir
    private static Path directory;

    private static List<JsonNode> buildings;
    private static JsonNode root;

    private static String node(int id, String latitude, String longitude) {
        return "<node id='" + id + "' lat='" + latitude + "' lon='" + longitude + "'/>";
    }

    @BeforeAll
    static void run() throws IOException {
        Files.writeString(directory.resolve("town.osm"), OSM);
        Files.writeString(
                directory.resolve("ground.obj"),
                "v -3000 -3000 0\nv 3000 -3000 0\nv 3000 3000 0\nv -3000 3000 0\nf 1 2 3 4\n");
        SceneRunner runner = new SceneRunner(new SceneFile(Files.writeString(directory.resolve("town.yaml"), SCENE)));
        SceneResult result = runner.run();
        SiteMap map = SiteMap.of(result, runner.stage(result.runs().get(0).settings()))
                .orElseThrow();
        map.writeGeoJson(directory.resolve("map.geojson"));
        map.writeKml(directory.resolve("map.kml"));
        root = JsonMapper.builder().build().readTree(Files.readString(directory.resolve("map.geojson")));
        buildings = new ArrayList<>();
        root.get("features").forEach(feature -> {
            if (feature.get("properties").get("folder").asString().equals("Buildings")) {
                buildings.add(feature);
            }
        });
    }

    private static JsonNode building(String id) {
        return buildings.stream()
                .filter(feature ->
                        feature.get("properties").get("id").asString().endsWith(id))
                .findFirst()
                .orElseThrow();
    }

    private static Polygon polygon(String id) throws ParseException {
        return (Polygon) new GeoJsonReader().read(building(id).get("geometry").toString());
    }

    /** Two kilometres from the origin, to the last of eight decimals: a millimetre. */
    @Test
    void outlinesComeBackWhereTheyWere() throws ParseException {
        assertThat(buildings).hasSize(3);
        assertCorners(
                polygon("100").getExteriorRing().getCoordinates(),
                new double[][] {{15.02, 50.01}, {15.0204, 50.01}, {15.0204, 50.0102}, {15.02, 50.0102}});
        Polygon block = polygon("104");
        assertThat(block.isValid()).isTrue();
        assertCorners(
                block.getExteriorRing().getCoordinates(),
                new double[][] {{15.02, 50.0104}, {15.0206, 50.0104}, {15.0206, 50.0108}, {15.02, 50.0108}});
        assertThat(block.getNumInteriorRing()).isEqualTo(1);
        assertCorners(
                block.getInteriorRingN(0).getCoordinates(),
                new double[][] {{15.0202, 50.0105}, {15.0204, 50.0105}, {15.0204, 50.0107}, {15.0202, 50.0107}});
    }

    private static void assertCorners(Coordinate[] ring, double[][] expected) {
        assertThat(ring).hasSize(expected.length + 1);
        for (double[] corner : expected) {
            assertThat(ring).as("%s %s", corner[0], corner[1]).anySatisfy(found -> {
                assertThat(found.x).isCloseTo(corner[0], within(1.1e-8));
                assertThat(found.y).isCloseTo(corner[1], within(1.1e-8));
            });
        }
    }

    @Test
    void heightsAreThoseOfTheMapOrMarkedAsAssumed() {
        JsonNode hall = building("100").get("properties");
        assertThat(hall.get("name").asString()).isEqualTo("Hall <A>");
        assertThat(hall.get("height_above_ground_m").asDouble()).isEqualTo(12.5);
        assertThat(hall.get("assumed").asBoolean()).isFalse();
        JsonNode block = building("104").get("properties");
        assertThat(block.get("height_above_ground_m").asDouble()).isEqualTo(7.0);
        assertThat(block.get("assumed").isBoolean()).isTrue();
        assertThat(block.get("assumed").asBoolean()).isTrue();
        assertThat(building("103")
                        .get("properties")
                        .get("bottom_above_ground_m")
                        .asDouble())
                .isEqualTo(6.0);
        assertThat(root.get("description").asString()).contains("(c) OpenStreetMap contributors", "'assumed'");
    }

    /** The yard's corners run clockwise in the scene. */
    @Test
    void protectedAreasHaveTheirFloorAndHeight() throws ParseException {
        List<JsonNode> zones = new ArrayList<>();
        root.get("features").forEach(feature -> {
            if (feature.get("properties").get("folder").asString().equals("Protected zones")) {
                zones.add(feature);
            }
        });
        assertThat(zones).hasSize(2);
        JsonNode yard = zones.get(0).get("properties");
        assertThat(yard.get("name").asString()).isEqualTo("yard");
        assertThat(yard.get("floor_above_ground_m").asDouble()).isEqualTo(5.0);
        assertThat(yard.get("height_above_ground_m").asDouble()).isEqualTo(40.0);
        assertThat(zones.get(1).get("properties").get("radius_m").asDouble()).isEqualTo(100.0);
        Polygon area =
                (Polygon) new GeoJsonReader().read(zones.get(0).get("geometry").toString());
        assertThat(Orientation.isCCW(area.getExteriorRing().getCoordinateSequence()))
                .isTrue();
        // 71,696 m and 111,229 m for a degree of longitude and of latitude at 50 degrees, and 300 m above the sea.
        assertThat(area.getArea()).isCloseTo(80 * 50 / (71_700.0 * 111_234.0), withinPercentage(0.01));
    }

    @Test
    void kmlRaisesThemToTheirHeight() throws Exception {
        new KmlSchema().validate(directory.resolve("map.kml"));
        DocumentBuilderFactory factory = DocumentBuilderFactory.newInstance();
        Document document =
                factory.newDocumentBuilder().parse(directory.resolve("map.kml").toFile());
        NodeList marks = document.getElementsByTagName("Placemark");
        int found = 0;
        for (int i = 0; i < marks.getLength(); i++) {
            Element mark = (Element) marks.item(i);
            if (text(mark, "name").equals("Hall <A>")) {
                found++;
                assertThat(text(mark, "altitudeMode")).isEqualTo("relativeToGround");
                assertThat(text(mark, "extrude")).isEqualTo("1");
                assertThat(text(mark, "coordinates").split(" ")).hasSize(5).allSatisfy(corner -> assertThat(corner)
                        .endsWith(",12.5"));
            }
        }
        assertThat(found).isEqualTo(1);
    }

    private static String text(Element element, String tag) {
        return element.getElementsByTagName(tag).item(0).getTextContent();
    }
}
