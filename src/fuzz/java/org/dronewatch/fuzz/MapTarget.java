package org.dronewatch.fuzz;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.zip.GZIPOutputStream;
import org.dronewatch.buildings.io.PbfWriter;

/**
 * Maps with buildings: OpenStreetMap XML, compressed or not, PBF, GeoJSON and CityJSON, damaged; PBF also inside its
 * blocks.
 */
final class MapTarget implements FuzzTarget {
    private static final double LATITUDE = 50.08;
    private static final double LONGITUDE = 14.42;
    private static final double METRE = 1e-5;

    @Override
    public String name() {
        return "map";
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        return switch ((int) (number % 6)) {
            case 0 -> scene("damaged OpenStreetMap XML", "town.osm", ByteMutation.of(utf8(xml(dice)), dice), dice);
            case 1 -> scene("damaged packed map", "town.osm.gz", ByteMutation.of(packed(utf8(xml(dice))), dice), dice);
            case 2 -> scene("damaged PBF", "town.osm.pbf", ByteMutation.of(pbf(dice), dice), dice);
            case 3 -> scene("PBF with a damaged block", "town.osm.pbf", damagedBlock(dice), dice);
            case 4 -> scene("damaged GeoJSON", "town.geojson", ByteMutation.of(utf8(geoJson(dice)), dice), dice);
            default -> scene("damaged CityJSON", "town.json", ByteMutation.of(utf8(cityJson(dice)), dice), dice);
        };
    }

    private static byte[] utf8(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    private static FuzzCase scene(String what, String file, byte[] content, Dice dice) {
        String others = dice.pick("", ", woodHeight: 12 m", ", radius: 300 m", ", height: 5 m");
        String scene =
                "world:\n  origin: {latitude: 50.08 deg, longitude: 14.42 deg, height: 200}\n  buildings: {file: "
                        + file + others + "}\n";
        return FuzzCase.of(what, "scene.yaml", scene, "check", "{}/scene.yaml").with(file, content);
    }

    private static Map<String, String> tags(Dice dice) {
        Map<String, String> tags = new LinkedHashMap<>();
        tags.put(
                dice.pick("building", "building", "building:part", "natural", "landuse"),
                dice.pick("yes", "no", "wood"));
        for (int i = dice.below(5); i > 0; i--) {
            tags.put(
                    dice.pick(
                            "height",
                            "min_height",
                            "building:levels",
                            "building:min_level",
                            "roof:shape",
                            "roof:height",
                            "roof:levels",
                            "roof:angle",
                            "roof:direction",
                            "building:material",
                            "location"),
                    dice.pick(
                            "12",
                            "9,5",
                            "40 ft",
                            "39'4\"",
                            "0",
                            "-3",
                            "1e9",
                            "NaN",
                            "99999999",
                            "gabled",
                            "hipped",
                            "dome",
                            "skillion",
                            "pyramidal",
                            "NW",
                            "270",
                            "90",
                            "underground",
                            "\u202E",
                            ""));
        }
        return tags;
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("\"", "&quot;").replace("<", "&lt;");
    }

    /** Houses of three to nine corners, some of which cross themselves, and a relation of some of them. */
    private static String xml(Dice dice) {
        StringBuilder nodes = new StringBuilder("<osm version=\"0.6\">\n");
        StringBuilder ways = new StringBuilder();
        StringBuilder members = new StringBuilder();
        int node = 0;
        int houses = dice.between(1, 6);
        for (int house = 1; house <= houses; house++) {
            int corners = dice.between(3, 9);
            ways.append("<way id=\"").append(house).append("\">");
            for (int i = 0; i < corners; i++) {
                nodes.append(String.format(
                        Locale.ROOT,
                        "<node id=\"%d\" lat=\"%.6f\" lon=\"%.6f\"/>%n",
                        ++node,
                        LATITUDE + METRE * dice.between(-60, 60),
                        LONGITUDE + METRE * dice.between(-60, 60)));
                ways.append("<nd ref=\"").append(node).append("\"/>");
            }
            ways.append("<nd ref=\"").append(node - corners + 1).append("\"/>");
            tags(dice).forEach((key, value) -> ways.append("<tag k=\"")
                    .append(key)
                    .append("\" v=\"")
                    .append(escaped(value))
                    .append("\"/>"));
            ways.append("</way>\n");
            members.append("<member type=\"way\" ref=\"")
                    .append(house)
                    .append("\" role=\"")
                    .append(dice.pick("outer", "inner", "", "outline"))
                    .append("\"/>");
        }
        String relation = dice.oneIn(2)
                ? "<relation id=\"1\">" + members
                        + "<tag k=\"type\" v=\"multipolygon\"/><tag k=\"building\" v=\"yes\"/></relation>"
                : "";
        return nodes.toString() + ways + relation + "</osm>\n";
    }

    private static byte[] packed(byte[] content) {
        ByteArrayOutputStream packed = new ByteArrayOutputStream();
        try (OutputStream gzip = new GZIPOutputStream(packed)) {
            gzip.write(content);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return packed.toByteArray();
    }

    private static byte[] pbf(Dice dice) {
        return PbfWriter.house(LATITUDE, LONGITUDE, dice.oneIn(2), tags(dice));
    }

    /** PBF with damage inside its blocks; damage to compressed blocks would be found by their checksum first. */
    private static byte[] damagedBlock(Dice dice) {
        ByteArrayOutputStream file = new ByteArrayOutputStream();
        try {
            file.writeBytes(PbfWriter.blob("OSMHeader", PbfWriter.text(4, "DenseNodes"), -1));
            for (byte[] block : PbfWriter.blocksOfAHouse(LATITUDE, LONGITUDE, dice.oneIn(2), tags(dice))) {
                file.writeBytes(PbfWriter.blob(
                        "OSMData",
                        dice.oneIn(3) ? block : ByteMutation.of(block, dice),
                        dice.oneIn(10) ? 1 << 20 : -1));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return file.toByteArray();
    }

    private static String ring(Dice dice) {
        StringBuilder ring = new StringBuilder("[");
        for (int i = dice.between(3, 9); i > 0; i--) {
            ring.append(String.format(
                    Locale.ROOT,
                    "[%.6f,%.6f],",
                    LONGITUDE + METRE * dice.between(-60, 60),
                    LATITUDE + METRE * dice.between(-60, 60)));
        }
        return ring + ring.substring(1, ring.indexOf("]") + 1) + "]";
    }

    private static String geoJson(Dice dice) {
        StringBuilder features = new StringBuilder();
        for (int i = dice.between(1, 5); i > 0; i--) {
            StringBuilder properties = new StringBuilder();
            tags(dice).forEach((key, value) -> properties
                    .append(properties.isEmpty() ? "" : ",")
                    .append('"')
                    .append(key)
                    .append("\":\"")
                    .append(value.replace("\"", "\\\""))
                    .append('"'));
            String rings = dice.oneIn(3) ? ring(dice) + "," + ring(dice) : ring(dice);
            features.append(features.isEmpty() ? "" : ",\n")
                    .append("{\"type\":\"Feature\",\"properties\":{")
                    .append(properties)
                    .append("},\"geometry\":{\"type\":\"Polygon\",\"coordinates\":[")
                    .append(rings)
                    .append("]}}");
        }
        return "{\"type\":\"FeatureCollection\",\"features\":[" + features + "]}";
    }

    /** A box in UTM zone 33N with or without a floor, some of whose corners are moved. */
    private static String cityJson(Dice dice) {
        StringBuilder vertices = new StringBuilder();
        for (int i = 0; i < 8; i++) {
            int moved = dice.oneIn(6) ? dice.between(-20_000, 20_000) : 0;
            vertices.append(i == 0 ? "" : ",")
                    .append(String.format(
                            Locale.ROOT,
                            "[%d,%d,%d]",
                            i == 1 || i == 2 || i == 5 || i == 6 ? 10_000 + moved : 0,
                            i == 2 || i == 3 || i == 6 || i == 7 ? 8000 : moved,
                            i > 3 ? 6000 : 0));
        }
        String floor = dice.oneIn(2) ? ",[[0,3,2,1]]" : "";
        return "{\"type\":\"CityJSON\",\"version\":\"" + dice.pick("1.1", "2.0")
                + "\",\"transform\":{\"scale\":[0.001,0.001,"
                + "0.001],\"translate\":[458502,5547686,200]},\"metadata\":{\"referenceSystem\":"
                + "\"https://www.opengis.net/def/crs/EPSG/0/32633\"},\"vertices\":[" + vertices
                + "],\"CityObjects\":{\"a\":{\"type\":\"Building\",\"geometry\":[{\"type\":\"Solid\",\"lod\":\""
                + dice.pick("1", "1.2", "2", "2.2", "3")
                + "\",\"boundaries\":[[[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],[[3,0,4,7]],"
                + "[[4,5,6,7]]" + floor + "]]}]}}}";
    }

    @Override
    public void judge(FuzzCase input, Path directory) {
        Judge.check(CommandRun.of(input.argumentsIn(directory)), directory);
    }
}
