package org.dronewatch.geo.features;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.SplittableRandom;
import org.dronewatch.geo.EarthPlace;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class FeaturesTest {
    private static final String KML =
            """
            <?xml version="1.0" encoding="UTF-8"?>
            <kml xmlns="http://www.opengis.net/kml/2.2"><Document><name>site</name><Folder><name>gates</name>
              <Placemark><name>north gate</name><Point><coordinates>7.42,43.73,12</coordinates></Point></Placemark>
              <Placemark><name>mast</name><Point><altitudeMode>relativeToGround</altitudeMode>
                <coordinates> 7.43,43.74,25 </coordinates></Point></Placemark>
              <Placemark><name>roof</name><Point><coordinates>7.44,43.75,99</coordinates>
                <altitudeMode>absolute</altitudeMode></Point></Placemark>
              <Placemark><name>fence</name><LineString><coordinates>1,2 3,4</coordinates></LineString></Placemark>
              <Placemark><name>twin</name><Point><coordinates>1,2</coordinates></Point></Placemark>
              <Placemark><name>twin</name><Point><coordinates>1,2</coordinates></Point></Placemark>
              <Placemark><Point><coordinates>5,6</coordinates></Point></Placemark>
            </Folder></Document></kml>
            """;

    private static final String GEOJSON =
            """
            {"type": "FeatureCollection", "features": [
              {"type": "Feature", "properties": {"name": "north gate"},
               "geometry": {"type": "Point", "coordinates": [7.42, 43.73]}},
              {"type": "Feature", "properties": {"name": "mast"},
               "geometry": {"type": "Point", "coordinates": [7.43, 43.74, 25.5]}},
              {"type": "Feature", "properties": {"name": "zero"},
               "geometry": {"type": "Point", "coordinates": [7.43, 43.74, 0]}},
              {"type": "Feature", "properties": {"name": "yard"},
               "geometry": {"type": "Polygon", "coordinates": [[[1, 2], [3, 4], [1, 3], [1, 2]]]}},
              {"type": "Feature", "properties": null, "geometry": null}
            ]}
            """;

    private static Features read(String text) {
        return Features.read("map", text.getBytes(StandardCharsets.UTF_8));
    }

    private static EarthPlace place(String text, String name) {
        return read(text).place(name, Optional.empty(), Optional.empty());
    }

    private static void assertAt(EarthPlace place, double latitude, double longitude, Double above, Double height) {
        assertThat(Math.toDegrees(place.latitude())).isEqualTo(latitude, within(1e-12));
        assertThat(Math.toDegrees(place.longitude())).isEqualTo(longitude, within(1e-12));
        assertThat(place.above()).isEqualTo(Optional.ofNullable(above));
        assertThat(place.height()).isEqualTo(Optional.ofNullable(height));
    }

    /** Heights count as the file says; on the ground if it says so. */
    @Test
    void placemarksAreAsHighAsTheirModeSays() {
        assertAt(place(KML, "north gate"), 43.73, 7.42, null, null);
        assertAt(place(KML, "mast"), 43.74, 7.43, 25.0, null);
        assertAt(place(KML, "roof"), 43.75, 7.44, null, 99.0);
        assertAt(read(KML).place(" roof ", Optional.of(3.0), Optional.empty()), 43.75, 7.44, 3.0, null);
        assertThat(Math.toDegrees(read(KML).point("mast").longitude())).isEqualTo(7.43, within(1e-12));
    }

    @Test
    void pointsOfGeoJsonNeedAClearHeight() {
        assertAt(place(GEOJSON, "north gate"), 43.73, 7.42, null, null);
        assertAt(place(GEOJSON, "zero"), 43.74, 7.43, null, null);
        assertAt(read(GEOJSON).place("mast", Optional.empty(), Optional.of(80.0)), 43.74, 7.43, null, 80.0);
        assertThatThrownBy(() -> place(GEOJSON, "mast"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessage("feature 'mast' has a height of 25.5 m in map, which does not state its reference:"
                        + " give 'above' or 'height'");
    }

    @Test
    void whatIsNoPointOrNotThereIsRefused() {
        assertThatThrownBy(() -> place(KML, "nroth gate"))
                .hasMessageContaining("there is none in map; closest matches: north gate");
        assertThatThrownBy(() -> place(KML, "fence"))
                .hasMessage("feature 'fence' at 8 of map is a LineString but must be a Point");
        assertThatThrownBy(() -> place(KML, "twin")).hasMessage("feature 'twin': there are 2 in map, at 9 and 10");
        assertThatThrownBy(() -> place(GEOJSON, "yard")).hasMessageContaining("is a Polygon but must be a Point");
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "7.42,43.73,12 | 7.42,43.73,12,1 | map:3: coordinates '7.42,43.73,12,1' must be longitude,latitude",
                "7.42,43.73,12 | 7.42,x | map:3: coordinates '7.42,x' must be",
                "7.42,43.73,12 | 7.42,143.73 | map:3: latitude 143.73 must be -90.0 to 90.0",
                "<kml xmlns | <!DOCTYPE kml [<!ENTITY a SYSTEM \"file:///etc/passwd\">]><kml xmlns | map:2: has a document type",
                "<kml xmlns=\"http://www.opengis.net/kml/2.2\"> | <osm> | map:2: begins with <osm> but must begin with <kml>",
                "</Folder> | '' | map:12: not well-formed XML",
            })
    void wrongKmlIsRefusedInALine(String old, String wrong, String message) {
        assertRefused(KML, old, wrong, message);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "[7.42, 43.73] | [7.42] | map:features.0: coordinates [7.42] must be numbers",
                "[7.42, 43.73] | [743, 43.73] | map:features.0: longitude 743.0 must be -180.0 to 180.0",
                "FeatureCollection | Topology | map: 'type' is 'Topology' but must be FeatureCollection or Feature",
                "]} | ] | not valid JSON",
            })
    void wrongGeoJsonIsRefusedInALine(String old, String wrong, String message) {
        assertRefused(GEOJSON, old, wrong, message);
    }

    /** The place of MapTransformTest's table that EPSG:32632 has at 373139.3367, 4844024.1247 (PROJ 9.5.1). */
    @ParameterizedTest
    @ValueSource(strings = {"urn:ogc:def:crs:EPSG::32632", "EPSG:32632"})
    void aGridThatTheFileStatesIsTransformed(String crs) {
        String text =
                "{\"type\": \"FeatureCollection\", \"crs\": {\"type\": \"name\", \"properties\": {\"name\": \"" + crs
                        + "\"}}, \"features\": [{\"type\": \"Feature\", \"properties\": {\"name\": \"gate\"}, \"geometry\":"
                        + " {\"type\": \"Point\", \"coordinates\": [373139.3367, 4844024.1247]}}]}";
        EarthPlace gate = place(text, "gate");
        assertThat(Math.toDegrees(gate.latitude())).isEqualTo(43.7384, within(2e-8));
        assertThat(Math.toDegrees(gate.longitude())).isEqualTo(7.4246, within(2e-8));

        assertRefused(
                text,
                "4844024.1247",
                "4844024.1e9",
                "map:features.0: point (373139.336700, 4844024100000000.000000) lies where EPSG:32632 has no coordinates");
        assertRefused(text, crs, "EPSG:1111", "map: crs: coordinate reference system 'EPSG:1111' is not known");
        // Without the statement, they are no degrees.
        assertRefused(
                text,
                "\"crs\"",
                "\"was\"",
                "map:features.0: latitude 4844024.1247 must be -90.0 to 90.0; 'ogr2ogr -s_srs EPSG:25832 -t_srs EPSG:4326");
        assertThat(place(
                        GEOJSON.replaceFirst(
                                "\\{",
                                "{\"crs\": {\"type\": \"name\", \"properties\": {\"name\":"
                                        + " \"urn:ogc:def:crs:OGC:1.3:CRS84\"}}, "),
                        "north gate"))
                .isEqualTo(place(GEOJSON, "north gate"));
    }

    private static void assertRefused(String text, String old, String wrong, String message) {
        assertThat(text).contains(old);
        assertThatThrownBy(() -> read(text.replace(old, wrong)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(message)
                .satisfies(e -> assertThat(e.getMessage().lines()).hasSize(1));
    }

    @Test
    void otherFilesAreRefused() {
        assertThatThrownBy(() -> read("PK\u0003\u0004")).hasMessageContaining("extract the .kml");
        assertThatThrownBy(() -> read("")).hasMessageContaining("is neither GeoJSON nor KML");
        assertThatThrownBy(() -> read("<kml>" + "<a>".repeat(100_000)))
                .hasMessageContaining("nested more than 64 deep");
        assertThatThrownBy(() -> read("{\"a\":".repeat(100_000))).isInstanceOf(InputException.class);
    }

    /** Whatever a file holds, it is read or refused in a line: seeds 0 to 999. */
    @Test
    void damagedFilesAreReadOrRefused() {
        for (int seed = 0; seed < 1000; seed++) {
            SplittableRandom random = new SplittableRandom(seed);
            byte[] bytes = (seed % 2 == 0 ? KML : GEOJSON).getBytes(StandardCharsets.UTF_8);
            for (int i = random.nextInt(1, 4); i > 0; i--) {
                bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
            }
            byte[] damaged = random.nextInt(4) == 0 ? Arrays.copyOf(bytes, random.nextInt(bytes.length)) : bytes;
            try {
                Features.read("map", damaged).place("mast", Optional.of(1.0), Optional.empty());
            } catch (InputException | IllegalArgumentException e) {
                assertThat(e.getMessage().lines()).as("seed %s", seed).hasSize(1);
            }
        }
    }
}
