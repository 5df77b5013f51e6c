package org.dronewatch.buildings.land;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.buildings.BuildingLoader;
import org.dronewatch.buildings.BuildingSettings;
import org.dronewatch.buildings.DrawnMap;
import org.dronewatch.buildings.LoadedBuildings;
import org.dronewatch.geo.Origin;
import org.dronewatch.setting.InputException;
import org.dronewatch.sound.surface.Grounds;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What maps show on the ground, from their tags to the raster, with areas worked out by hand. */
class LandSurveyTest {
    private static final Origin ORIGIN =
            Origin.at(Math.toRadians(50.0), Math.toRadians(15.0)).withHeight(0.0);
    private static final double[] SQUARE = {-50, -50, 50, -50, 50, 50, -50, 50};

    @TempDir
    private Path directory;

    private final DrawnMap map = new DrawnMap(ORIGIN);

    private LoadedBuildings load(String text) throws IOException {
        return load(text, 100);
    }

    private LoadedBuildings load(String text, double radius) throws IOException {
        Files.writeString(directory.resolve("map"), text);
        return new BuildingLoader(directory)
                .load(BuildingSettings.of("map").withRadius(radius).withLandCover(true), ORIGIN, Optional.empty());
    }

    private LandRaster cover() throws IOException {
        return load(map.osm()).landCover().orElseThrow();
    }

    private static double area(LandRaster cover, LandClass land) {
        return cover.areas()[land.code()];
    }

    /** Tags of squares, and what they are. */
    private static final String AREAS =
            """
            landuse=forest, WOOD
            natural=wood, WOOD
            natural=water, WATER
            landuse=meadow, GRASS
            leisure=pitch, GRASS
            leisure=pitch sport=tennis, PAVED
            leisure=pitch surface=gravel, UNPAVED
            amenity=parking, PAVED
            amenity=parking surface=grass_paver, GRASS
            amenity=parking parking=underground, NONE
            amenity=parking building=yes, NONE
            amenity=school, NONE
            landuse=residential, RESIDENTIAL
            landuse=residential natural=wood, WOOD
            landuse=quarry, ROCK
            natural=beach, SAND
            natural=beach surface=pebblestone, UNPAVED
            highway=pedestrian area=yes, PAVED
            man_made=pier, PAVED
            man_made=bridge, NONE
            landuse=grass area=no, NONE
            natural=wood tunnel=no, WOOD
            natural=water tunnel=culvert, NONE
            """;

    @Test
    void areasHaveTheClassOfTheirTags() throws IOException {
        String[] rows = AREAS.strip().split("\\R");
        for (int i = 0; i < rows.length; i++) {
            double x = 10 * i - 99;
            map.area(new double[] {x, 0, x + 6, 0, x + 6, 6, x, 6}, rows[i].split(", ")[0]);
        }
        LandRaster cover = load(map.osm(), 200).landCover().orElseThrow();
        for (int i = 0; i < rows.length; i++) {
            assertThat(cover.at(10 * i - 96, 3)).as(rows[i]).hasToString(rows[i].split(", ")[1]);
        }
        assertThat(area(cover, LandClass.NONE)).isEqualTo(400 * 400 - 36 * 17);
    }

    @ParameterizedTest
    @CsvSource({
        "highway=motorway, ROAD, 11",
        "highway=residential, ROAD, 6",
        "highway=residential|width=9, ROAD, 9",
        "highway=residential|width=30 ft, ROAD, 9.144",
        "highway=residential|width=wide|lanes=3, ROAD, 9.75",
        "highway=residential|width=0, ROAD, 6",
        "highway=residential|width=4711, ROAD, 6",
        "highway=residential|surface=sett, ROAD, 6",
        "highway=residential|surface=gravel, UNPAVED, 6",
        "highway=track, UNPAVED, 3",
        "highway=track|surface=asphalt, PAVED, 3",
        "highway=cycleway, PAVED, 2.5",
        "railway=rail, RAILWAY, 5",
        "waterway=stream, WATER, 2",
        "aeroway=runway, PAVED, 45",
        "man_made=breakwater, ROCK, 6"
    })
    void linesHaveTheWidthOfTheirKindUnlessTheyStateIt(String tags, LandClass land, double width) {
        LandUse use = LandTags.line(tags(tags)).orElseThrow();
        assertThat(use.land()).isEqualTo(land);
        assertThat(use.width()).isEqualTo(width, within(1e-9));
        assertThat(LandTags.isOffTheGround(tags(tags))).isFalse();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "railway=abandoned",
                "highway=proposed",
                "natural=cliff",
                "highway=pedestrian|area=yes",
                "railway=rail|tunnel=yes",
                "highway=primary|bridge=viaduct",
                "highway=footway|indoor=yes"
            })
    void otherLinesCoverNothing(String tags) {
        assertThat(LandTags.line(tags(tags)).isEmpty() || LandTags.isOffTheGround(tags(tags)))
                .isTrue();
    }

    private static Map<String, String> tags(String text) {
        return Arrays.stream(text.split("[|]"))
                .map(tag -> tag.split("="))
                .collect(Collectors.toMap(pair -> pair[0], pair -> pair[1]));
    }

    /** From a lake in a wood in a field, crossed by a bridge, a road and a railway, to what is seen from above. */
    @Test
    void smallerAreasLieOnLargerOnesAndRoadsOnAll() throws IOException {
        map.line(new double[] {-90, 0, 90, 0}, "highway=residential");
        map.line(new double[] {0, -90, 0, 90}, "railway=rail");
        map.line(new double[] {-90, 30, 90, 30}, "highway=residential bridge=yes");
        map.area(new double[] {-20, -20, 20, -20, 20, 20, -20, 20}, "natural=water");
        map.area(SQUARE, "natural=wood");
        map.area(new double[] {-80, -80, 80, -80, 80, 80, -80, 80}, "landuse=farmland");
        LandRaster cover = cover();

        assertThat(area(cover, LandClass.ROAD)).isCloseTo(180 * 6 + 28, within(10.0));
        assertThat(area(cover, LandClass.RAILWAY)).isCloseTo(5 * (180 - 6) + 20, within(10.0));
        assertThat(area(cover, LandClass.WATER)).isCloseTo((40 - 6) * (40 - 5), within(1e-6));
        assertThat(area(cover, LandClass.WOOD)).isCloseTo((100 - 6) * (100 - 5) - 34 * 35, within(1e-6));
        assertThat(area(cover, LandClass.FARMLAND)).isCloseTo((160 - 6) * (160 - 5) - 94 * 95, within(1e-6));
        assertThat(load(map.osm()).description())
                .contains("land cover: left out: 1 road or area on a bridge, in a tunnel or underground")
                .anyMatch(line ->
                        line.startsWith("land cover: 200 x 200 cells of 1 m: farmland 14,940 m2, wood 7,740 m2, "))
                .anyMatch(line -> line.endsWith("; not stated for 35 %"));
    }

    /** A lake that reaches 12 km to the east of the area, in two ways, one of which has no node in it; an island. */
    private void lake() {
        int near = map.line(new double[] {9000, -60, -50, -60, -50, 60, 9000, 60}, "");
        map.line(new double[] {12_000, 0, 12_000, 10}, "");
        int far = map.wayThrough(7, "", 4, 5, 1);
        map.wayThrough(8, "amenity=school", 5, 6);
        int island = map.area(new double[] {0, -10, 20, -10, 20, 10, 0, 10}, "landuse=grass");
        assertThat(island).isEqualTo(1007);
        map.relation("outer=" + near + " outer=" + far + " inner=" + island, "type=multipolygon natural=water");
    }

    @Test
    void aLakeBeyondTheAreaIsReadWhole() throws IOException {
        lake();
        for (String text : new String[] {map.osm(), map.osmOfOverpass()}) {
            LoadedBuildings loaded = load(text);
            LandRaster cover = loaded.landCover().orElseThrow();
            assertThat(area(cover, LandClass.WATER)).isCloseTo(120 * 150 - 400, within(1e-6));
            assertThat(area(cover, LandClass.GRASS)).isCloseTo(400, within(1e-6));
            assertThat(loaded.warnings()).isEmpty();
        }
    }

    @Test
    void aLakeThatTheFileDoesNotHoldWholeIsLeftOutWithAWarning() throws IOException {
        lake();
        LoadedBuildings loaded = load(map.osm().replaceFirst("<way id='7'>.*", ""));
        assertThat(area(loaded.landCover().orElseThrow(), LandClass.WATER)).isZero();
        assertThat(loaded.warnings())
                .containsExactly("map: land cover: 1 area whose outline is incomplete in the file is left out:"
                        + " relation/9; 'osmium extract --strategy smart' extracts a map with complete areas");
        map.wayThrough(99, "natural=water", 1, 2, 4711, 1);
        map.wayThrough(98, "highway=track", 2, 4711, 2, 3);
        LandRaster cover = load(map.osm()).landCover().orElseThrow();
        assertThat(area(cover, LandClass.UNPAVED)).isCloseTo(3 * 120 + 7, within(5.0));
    }

    /** In a bay: a coast from the north to the south has the sea in the west. */
    @Test
    void theSeaIsWater() throws IOException {
        map.line(new double[] {10, -3000, 10, 0}, "natural=coastline");
        map.line(new double[] {10, 0, 10, 3000}, "natural=coastline");
        map.line(new double[] {-90, 0, 90, 0}, "man_made=pier width=2");
        LandRaster cover = cover();
        assertThat(area(cover, LandClass.WATER)).isCloseTo(90 * 200 - 2 * 80, within(10.0));
        assertThat(cover.at(50, 50)).isEqualTo(LandClass.WATER);
        assertThat(cover.at(-50, 50)).isEqualTo(LandClass.NONE);
        assertThat(cover.at(50, 0.5)).isEqualTo(LandClass.PAVED);
    }

    @Test
    void geoJsonStatesLandCoverToo() throws IOException {
        String lake = "[[15,50],[15.001,50],[15.001,50.0005],[15,50.0005],[15,50]]";
        String text =
                """
                {"type": "FeatureCollection", "features": [
                  {"type": "Feature", "properties": {"natural": "water"},
                   "geometry": {"type": "Polygon", "coordinates": [%1$s]}},
                  {"type": "Feature", "properties": {"highway": "track", "width": 4},
                   "geometry": {"type": "MultiLineString", "coordinates": [[[14.999,49.9998],[15.001,49.9998]]]}},
                  {"type": "Feature", "properties": {"natural": "coastline"},
                   "geometry": {"type": "LineString", "coordinates": [[14.99,49.9995],[15.01,49.9995]]}}]}
                """
                        .formatted(lake);
        LoadedBuildings loaded = load(text);
        LandRaster cover = loaded.landCover().orElseThrow();
        assertThat(loaded.count()).isZero();
        assertThat(cover.at(10, 10)).isEqualTo(LandClass.WATER);
        assertThat(cover.at(10, -22.2)).isEqualTo(LandClass.UNPAVED);
        assertThat(cover.at(10, -70)).isEqualTo(LandClass.WATER);

        // Without land cover, an area is a building, and lines are left out.
        LoadedBuildings plain =
                new BuildingLoader(directory).load(BuildingSettings.of("map"), ORIGIN, Optional.empty());
        assertThat(plain.count()).isEqualTo(1);
        assertThat(plain.description()).contains("buildings: left out: 1 MultiLineString, 1 LineString");
    }

    @Test
    void aMapWithoutLandCoverSaysSo() throws IOException {
        map.area(SQUARE, "building=yes height=3");
        assertThat(load(map.osm()).warnings())
                .containsExactly("map: has no land cover near the origin: all ground keeps its material");
        assertThatThrownBy(() -> load("<osm><node id='1' lat='50' lon='15'/></osm>"))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("has no building within 100 m of the origin");
    }

    /** Every material has a surface and a ground in the tables, and no two classes share a name or a colour. */
    @Test
    void everyClassHasItsSurface() {
        TreeMap<String, Long> names = Arrays.stream(LandClass.values())
                .filter(land -> land != LandClass.NONE)
                .peek(land -> {
                    String surface = land.material().replaceFirst(":.*", "");
                    assertThat(SurfaceMaterials.find(surface)).as(surface).isPresent();
                    assertThat(Grounds.find(surface)).as(surface).isPresent();
                })
                .flatMap(land -> Stream.of(land.material(), "" + land.colour(), land.words()))
                .collect(Collectors.groupingBy(text -> text, TreeMap::new, Collectors.counting()));
        assertThat(names.values()).containsOnly(1L);
    }
}
