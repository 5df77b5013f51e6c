package org.dronewatch.buildings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.Random;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.InputException;
import org.dronewatch.terrain.TerrainGround;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** City models that are written by hand, about 50 N 15 E, which UTM 33N has at 500000, 5538630.70. */
class CityModelTest {
    private static final Origin ORIGIN =
            Origin.at(Math.toRadians(50.0), Math.toRadians(15.0)).withHeight(200.0);

    /** The grid is smaller than the ground along its central meridian, and more so 203 m above the ellipsoid. */
    private static final double SCALE = 0.9996 / (1.0 + 203.0 / 6.381e6);

    /** A box of 10 m x 8 m x 6 m: four walls and a roof, outward. */
    private static final String WALLS = "[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],[[3,0,4,7]],[[4,5,6,7]]";

    private static final String FLOOR = ",[[0,3,2,1]]";

    private static final String BOX =
            "[0,0,0],[10000,0,0],[10000,8000,0],[0,8000,0],[0,0,6000],[10000,0,6000],[10000,8000,6000],[0,8000,6000]";

    @TempDir
    private Path directory;

    private static String city(String vertices, String objects) {
        return String.format(
                Locale.ROOT,
                "{\"type\":\"CityJSON\",\"version\":\"2.0\",\"transform\":{\"scale\":[0.001,0.001,0.001],\"translate\":"
                        + "[500000,5538630.7,200]},\"metadata\":{\"referenceSystem\":"
                        + "\"https://www.opengis.net/def/crs/EPSG/0/32633\"},\"vertices\":[%s],\"CityObjects\":{%s}}",
                vertices,
                objects);
    }

    private static String solid(String surfaces) {
        return "\"b\":{\"type\":\"Building\",\"geometry\":[{\"type\":\"Solid\",\"lod\":\"1\",\"boundaries\":[["
                + surfaces + "]]}]}";
    }

    private LoadedBuildings load(String text) throws IOException {
        return load(text, BuildingSettings.of("city.json"), Optional.empty());
    }

    private LoadedBuildings load(String text, BuildingSettings settings, Optional<TerrainGround> terrain)
            throws IOException {
        Files.writeString(directory.resolve("city.json"), text);
        return new BuildingLoader(directory).load(settings, ORIGIN, terrain);
    }

    /** The box, enlarged 30 times, is 300 m x 240 m; the origin is 120 m or more from each of its walls, or 20 m. */
    @ParameterizedTest
    @CsvSource({"150, 120, true", "150, -20, true", "150, -101, false"})
    void aSolidAroundTheOriginIsIncluded(double west, double south, boolean isIn) throws IOException {
        StringBuilder corners = new StringBuilder();
        for (int z : new int[] {0, 6}) {
            for (int[] at : new int[][] {{0, 0}, {300, 0}, {300, 240}, {0, 240}}) {
                corners.append(String.format(
                        Locale.ROOT,
                        "%s[%.0f,%.0f,%d]",
                        corners.isEmpty() ? "" : ",",
                        1000 * (at[0] - west),
                        1000 * (at[1] - south),
                        1000 * z));
            }
        }
        String text = city(corners.toString(), solid(WALLS));
        BuildingSettings settings = BuildingSettings.of("city.json").withRadius(100);
        if (isIn) {
            assertThat(load(text, settings, Optional.empty()).count()).isEqualTo(1);
        } else {
            assertThatThrownBy(() -> load(text, settings, Optional.empty())).hasMessageContaining("no building within");
        }
    }

    @Test
    void aMissingFloorIsAdded() throws IOException {
        LoadedBuildings open = load(city(BOX, solid(WALLS)));
        LoadedBuildings closed = load(city(BOX, solid(WALLS + FLOOR)));

        for (LoadedBuildings loaded : new LoadedBuildings[] {open, closed}) {
            assertThat(loaded.mesh().triangleCount()).isEqualTo(12);
            assertThat(BuildingLoaderTest.volume(loaded.mesh())).isCloseTo(480.0 / (SCALE * SCALE), within(0.01));
            BuildingLoaderTest.assertClosed(loaded.mesh());
            assertThat(loaded.area()).isCloseTo(80.0 / (SCALE * SCALE), within(0.001));
            assertThat(loaded.warnings()).isEmpty();
        }
        assertThat(open.description()).contains("buildings: 12 triangles; 1 solid had no floor, which was added");
        assertThat(closed.description()).contains("buildings: 12 triangles; all solids have floors");
    }

    /** A court of 2 m x 2 m: the floor has an opening, and so has the roof. */
    @Test
    void aFloorHasTheCourtyardOfItsRoof() throws IOException {
        String court = ",[4000,3000,0],[6000,3000,0],[6000,5000,0],[4000,5000,0],[4000,3000,6000],[6000,3000,6000],"
                + "[6000,5000,6000],[4000,5000,6000]";
        String surfaces = "[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],[[3,0,4,7]],[[4,5,6,7],[12,15,14,13]],"
                + "[[9,8,12,13]],[[10,9,13,14]],[[11,10,14,15]],[[8,11,15,12]]";
        LoadedBuildings loaded = load(city(BOX + court, solid(surfaces)));
        BuildingLoaderTest.assertClosed(loaded.mesh());
        assertThat(BuildingLoaderTest.volume(loaded.mesh())).isCloseTo(76.0 * 6.0 / (SCALE * SCALE), within(0.01));

        // Its rim as a plan shows it.
        assertThat(loaded.outlines()).hasSize(1);
        BuildingOutline outline = loaded.outlines().get(0);
        assertThat(Rings.signedArea(outline.outer())).isCloseTo(80.0 / (SCALE * SCALE), within(0.001));
        assertThat(outline.courts()).hasSize(1);
        assertThat(Rings.signedArea(outline.courts().get(0))).isCloseTo(-4.0 / (SCALE * SCALE), within(0.001));
        assertThat(outline.top()).isCloseTo(6.0, within(0.001));
        assertThat(outline.isAssumed()).isFalse();
    }

    /** The second level is taken, not the first nor the third; the outline of a building with parts has none. */
    @Test
    void theBestLevelWithoutWindowsIsTaken() throws IOException {
        String low = BOX.replace("6000]", "4000]");
        String objects = "\"whole\":{\"type\":\"Building\",\"children\":[\"part\"]},\"road\":{\"type\":\"Road\"},"
                + "\"part\":{\"type\":\"BuildingPart\",\"parents\":[\"whole\"],\"geometry\":["
                + "{\"type\":\"Solid\",\"lod\":\"1.3\",\"boundaries\":[[" + shifted(WALLS + FLOOR) + "]]},"
                + "{\"type\":\"MultiSurface\",\"lod\":\"2.2\",\"boundaries\":[" + WALLS + FLOOR + "]},"
                + "{\"type\":\"Solid\",\"lod\":\"3\",\"boundaries\":[[" + shifted(WALLS) + "]]}]}";
        LoadedBuildings loaded = load(city(BOX + "," + low, objects));
        assertThat(loaded.count()).isEqualTo(1);
        assertThat(BuildingLoaderTest.volume(loaded.mesh())).isCloseTo(480.0 / (SCALE * SCALE), within(0.01));
        assertThat(loaded.description()).contains("buildings: left out: 1 Road");
    }

    /** The same surfaces of the second box. */
    private static String shifted(String surfaces) {
        StringBuilder text = new StringBuilder();
        for (char one : surfaces.toCharArray()) {
            text.append(Character.isDigit(one) ? Integer.toString(one - '0' + 8) : String.valueOf(one));
        }
        return text.toString();
    }

    @Test
    void aWallThatIsMissingIsNamed() throws IOException {
        LoadedBuildings loaded = load(city(BOX, solid(WALLS.replace("[[0,1,5,4]],", ""))));
        assertThat(loaded.warnings()).contains("city.json: the solid is not closed: b");
    }

    @Test
    void heightsFromAnotherLevelAreDoubted() throws IOException {
        float[] corners = {-100, -100, -48, 100, -100, -48, 100, 100, -48, -100, 100, -48};
        Optional<TerrainGround> ground =
                Optional.of(new TerrainGround(TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3})));
        BuildingSettings settings = BuildingSettings.of("city.json");
        LoadedBuildings floating = load(city(BOX, solid(WALLS)), settings, ground);
        assertThat(floating.description().get(1))
                .endsWith("lowest points from 48.0 to 48.0 m above the ground, median 48.0 m");
        assertThat(floating.warnings())
                .anyMatch(line -> line.startsWith("city.json: its buildings lie 48.0 m above the ground (median)"));
        assertThat(load(city(BOX, solid(WALLS)), settings.withVerticalOffset(-48), ground)
                        .warnings())
                .isEmpty();
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "[0,1,99] | city.json: b: vertex '99' must be 0 to 7",
                "[0,1,-1] | city.json: b: vertex '-1' must be 0 to 7",
                "[0,1,1.5] | city.json: b: vertex '1.5' must be 0 to 7",
                "[0,1,\"x\"] | city.json: b: vertex '\"x\"' must be 0 to 7",
            })
    void verticesThatAreNotThereAreRefused(String ring, String message) {
        assertThatThrownBy(() -> load(city(BOX, solid("[" + ring + "]"))))
                .isInstanceOf(InputException.class)
                .hasMessage(message);
    }

    @Test
    void withoutItsSystemAModelIsNowhere() throws IOException {
        String text = city(BOX, solid(WALLS)).replaceFirst("\"metadata\":\\{[^}]*},", "");
        assertThatThrownBy(() -> load(text))
                .isInstanceOf(InputException.class)
                .hasMessage(
                        "city.json: does not state its coordinate reference system: set crs, as in crs: EPSG:25832");
        assertThat(load(text, BuildingSettings.of("city.json").withCrs("EPSG:32633"), Optional.empty())
                        .count())
                .isEqualTo(1);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0.9", "3.0", ""})
    void otherVersionsAreRefused(String version) {
        assertThatThrownBy(() -> load(city(BOX, solid(WALLS)).replace("\"2.0\"", "\"" + version + "\"")))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("must be 1.0 to 2.0");
    }

    /** Characters changed at random give buildings or one line. */
    @Test
    void damagedFilesGiveOneLine() throws IOException {
        long seed = 24112026L;
        Random random = new Random(seed);
        String whole = city(BOX, solid(WALLS));
        for (int i = 0; i < 500; i++) {
            StringBuilder text = new StringBuilder(whole);
            for (int k = 0; k < 1 + i % 3; k++) {
                text.setCharAt(random.nextInt(text.length()), "[]{},:0129\"x".charAt(random.nextInt(12)));
            }
            try {
                load(text.toString());
            } catch (InputException e) {
                assertThat(e.getMessage()).as("seed %d, case %d", seed, i).doesNotContain("\n");
            }
        }
    }
}
