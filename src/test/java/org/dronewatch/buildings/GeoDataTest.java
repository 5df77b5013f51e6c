package org.dronewatch.buildings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.FloatBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.buildings.io.MapArea;
import org.dronewatch.buildings.io.MapFeatures;
import org.dronewatch.buildings.io.MapFiles;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.LoadedModel;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.InputException;
import org.dronewatch.terrain.LoadedTerrain;
import org.dronewatch.terrain.TerrainLoader;
import org.dronewatch.terrain.TerrainSettings;
import org.dronewatch.terrain.io.ElevationFile;
import org.dronewatch.terrain.io.ElevationFiles;
import org.dronewatch.terrain.io.Window;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Files of other people that may not be shipped, in the directory named by {@value #PROPERTY}: where each comes from is
 * on the page about testing. Prints each figure. The whole takes a minute.
 */
@EnabledIfSystemProperty(named = GeoDataTest.PROPERTY, matches = ".+")
class GeoDataTest {
    static final String PROPERTY = "dronewatch.geo";

    private static final String LIDAR = "TM1_564_146.tif";

    /** Of the window that the variants hold. */
    private static final int SIDE = 300;

    private static final double[] ABOVE = {0, 2, 5, 10, 20};

    private final Path directory = Path.of(System.getProperty(PROPERTY, ""));

    private static void print(String format, Object... values) {
        System.out.printf(Locale.ROOT, format + "%n", values);
    }

    private static float[] all(ElevationFile file) throws IOException {
        return file.heights(new Window(0, 0, file.columns(), file.rows()));
    }

    private float[] reference() throws IOException {
        byte[] bytes = Files.readAllBytes(directory.resolve("variants/ref.f32"));
        FloatBuffer floats =
                ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asFloatBuffer();
        float[] reference = new float[floats.remaining()];
        floats.get(reference);
        return reference;
    }

    private float[] variant(String name) throws IOException {
        ElevationFile file = new ElevationFiles(directory.resolve("variants")).open(name + ".tif");
        assertThat(file.columns()).isEqualTo(SIDE);
        assertThat(file.rows()).isEqualTo(SIDE);
        return all(file);
    }

    /** Each encoding gives the same floats, bit for bit. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "bigendian_deflate_p3",
                "bigtiff_deflate_p3",
                "cog_deflate_p3",
                "float64_deflate_p3",
                "packbits",
                "strip_lzw",
                "strip_lzw_p2",
                "strip_lzw_p3",
                "strip_none",
                "tiled_deflate_p2",
                "tiled_deflate_p3",
            })
    void encodingsHoldTheSameHeights(String name) throws IOException {
        float[] heights = variant(name);
        assertThat(heights).containsExactly(reference());
        print("%s: %d heights as in ref.f32", name, heights.length);
    }

    @ParameterizedTest
    @ValueSource(strings = {"int16_bigendian_lzw_p2", "int16_deflate_p2"})
    void wholeMetresAreTheRoundedHeights(String name) throws IOException {
        float[] reference = reference();
        for (int i = 0; i < reference.length; i++) {
            reference[i] = (float) Math.rint(reference[i]);
        }
        assertThat(variant(name)).containsExactly(reference);
        print("%s: heights of ref.f32, rounded", name);
    }

    /** The missing posts, and all others as they are. */
    @ParameterizedTest
    @ValueSource(strings = {"nodata_holes", "sparse_missing_tile"})
    void whatIsMissingIsAHole(String name) throws IOException {
        float[] reference = reference();
        float[] heights = variant(name);
        int holes = 0;
        for (int i = 0; i < reference.length; i++) {
            if (Float.isNaN(heights[i])) {
                holes++;
            } else {
                assertThat(heights[i]).as("post %d", i).isEqualTo(reference[i]);
            }
        }
        print("%s: %,d holes, all other heights as in ref.f32", name, holes);
        assertThat(holes).isEqualTo(name.startsWith("nodata") ? 900 : 13_200);
    }

    @ParameterizedTest
    @ValueSource(strings = {"lzma", "tiled_lerc", "tiled_zstd_p3"})
    void otherEncodingsAreNamedWithTheCommandThatConvertsThem(String name) {
        assertThatThrownBy(() -> variant(name))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("gdal_translate")
                .satisfies(e -> assertThat(e.getMessage()).doesNotContain("\n"))
                .satisfies(e -> print("%s: %s", name, e.getMessage()));
    }

    /** The lidar heights as a terrain whose origin is a post. */
    private final class Lidar {
        final ElevationFile file = new ElevationFiles(directory).open(LIDAR);
        final float[] heights = heights();
        final Origin origin;
        final MapTransform map;

        Lidar(int row, int column) {
            Origin near = Origin.at(Math.toRadians(46), Math.toRadians(15));
            GeoPoint post = new MapTransform(file.crs().orElseThrow(), near)
                    .onEarth(file.lattice().xAt(column, row), file.lattice().yAt(column, row), 0.0);
            origin = Origin.at(Math.toRadians(post.latitude()), Math.toRadians(post.longitude()))
                    .withHeight(0.0);
            map = new MapTransform(file.crs().orElseThrow(), origin);
        }

        private float[] heights() {
            try {
                return all(file);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        double height(int row, int column) {
            return heights[row * file.columns() + column];
        }

        Position above(int row, int column, double height) {
            return map.inWorld(
                    file.lattice().xAt(column, row), file.lattice().yAt(column, row), height(row, column) + height);
        }

        LoadedTerrain load(double accuracy) {
            return new TerrainLoader(directory, line -> {})
                    .load(TerrainSettings.of(LIDAR).withAccuracy(accuracy), origin);
        }
    }

    /** The least height above a post at which a point is seen, m. */
    private static double leastHeight(Lidar lidar, Visibility visibility, Position observer, int row, int column) {
        if (visibility.isFree(observer, lidar.above(row, column, 1e-4))) {
            return 0.0;
        }
        double low = 0.0;
        double high = 200.0;
        while (high - low > 1e-5) {
            double middle = 0.5 * (low + high);
            if (visibility.isFree(observer, lidar.above(row, column, middle))) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return high;
    }

    /**
     * Against GDAL 3.10's viewshed (GROUND, without curvature), the observer 10 m above post (500, 500). GDAL does not
     * cut squares into triangles, and triangles put .417 of the ground in sight (see
     * {@link #leastHeightsAreThoseOfTheExactSightLines()}).
     */
    @Test
    void whatIsSeenOfALidarTerrainIsAsGdalHasIt() {
        Lidar lidar = new Lidar(500, 500);
        Visibility visibility = new Visibility(World.of(lidar.load(0).mesh()));
        Position observer = lidar.above(500, 500, 10.0);
        double[] gdal = {.4252, .725, .813, .8865, .952};
        int columns = lidar.file.columns();
        int rows = lidar.file.rows();
        for (int k = 0; k < ABOVE.length; k++) {
            int seen = 0;
            for (int i = 0; i < rows * columns; i++) {
                Position target = lidar.above(i / columns, i % columns, ABOVE[k] + 1e-4);
                seen += visibility.isFree(observer, target) ? 1 : 0;
            }
            double share = seen / ((double) rows * columns);
            print("seen at %.0f m: %.4f, by GDAL %.4f", ABOVE[k], share, gdal[k]);
            assertThat(share).isCloseTo(gdal[k], within(k == 0 ? .015 : .005));
        }
        int[][] posts = {{900, 900}, {100, 900}, {500, 999}};
        double[] least = {7.51, 14.809, 30.462};
        for (int i = 0; i < posts.length; i++) {
            double found = leastHeight(lidar, visibility, observer, posts[i][0], posts[i][1]);
            print("least height at %d, %d: %.3f m, by GDAL %.3f m", posts[i][0], posts[i][1], found, least[i]);
            assertThat(found).isCloseTo(least[i], within(0.05));
        }
    }

    /** The window of 100 x 100 posts around its middle, post by post. */
    @Test
    void leastHeightsAreThoseOfTheExactSightLines() {
        Lidar lidar = new Lidar(500, 500);
        Visibility visibility = new Visibility(World.of(lidar.load(0).mesh()));
        Position observer = lidar.above(500, 500, 2.0);
        double greatest = 0.0;
        int hidden = 0;
        int apart = 0;
        for (int row = 450; row < 550; row++) {
            for (int column = 450; column < 550; column++) {
                if (row == 500 && column == 500) {
                    continue;
                }
                double found = leastHeight(lidar, visibility, observer, row, column);
                double exact = exact(lidar, 500, 500, 2.0, row, column);
                double difference = Math.abs(found - exact);
                hidden += exact > 0.0 ? 1 : 0;
                apart += difference > 1e-3 ? 1 : 0;
                greatest = Math.max(greatest, difference);
            }
        }
        print(
                "least heights of 9,999 posts, %,d of them hidden: %d differ by more than 1 mm, at most by %.5f m",
                hidden, apart, greatest);
        assertThat(hidden).isBetween(1000, 9000);
        assertThat(greatest).isLessThan(1e-3);
    }

    /**
     * The least height above a post at which a sight line passes all triangles, whose edges it crosses where the
     * column, the row, or their difference is a whole number. The earth falls by d^2 / 2 R.
     */
    private static double exact(Lidar lidar, int fromRow, int fromColumn, double above, int row, int column) {
        int down = row - fromRow;
        int right = column - fromColumn;
        double radius = 6_371_008.8;
        double range = Math.hypot(down, right);
        double eye = lidar.height(fromRow, fromColumn) + above;
        double steepest = Double.NEGATIVE_INFINITY;
        for (int steps : new int[] {right, down, right - down}) {
            for (int i = 1; i < Math.abs(steps); i++) {
                double t = i / (double) Math.abs(steps);
                double distance = t * range;
                double ground = onTriangles(lidar, fromRow + t * down, fromColumn + t * right)
                        - distance * distance / (2.0 * radius);
                steepest = Math.max(steepest, (ground - eye) / distance);
            }
        }
        double needed = eye + steepest * range;
        double there = lidar.height(row, column) - range * range / (2.0 * radius);
        return Math.max(0.0, needed - there);
    }

    /** The height of the triangles, whose squares are cut from north-west to south-east. */
    private static double onTriangles(Lidar lidar, double row, double column) {
        int r = (int) Math.floor(row + 1e-9);
        int c = (int) Math.floor(column + 1e-9);
        double v = row - r;
        double u = column - c;
        double corner = lidar.height(r, c);
        double across = lidar.height(r + 1, c + 1);
        return u >= v
                ? corner + (lidar.height(r, c + 1) - corner) * u + (across - lidar.height(r, c + 1)) * v
                : corner + (lidar.height(r + 1, c) - corner) * v + (across - lidar.height(r + 1, c)) * u;
    }

    /** As few as another program's greedy insertion needs, but for a fifth. */
    @Test
    void thinningOutKeepsAsFewTrianglesAsAnother() {
        Lidar lidar = new Lidar(500, 500);
        double[] accuracies = {1.0, 0.5, 0.25};
        int[] others = {4969, 16_543, 56_028};
        for (int i = 0; i < others.length; i++) {
            LoadedTerrain terrain = lidar.load(accuracies[i]);
            int triangles = terrain.mesh().triangleCount();
            print(
                    "%s m: %,d triangles, by another program %,d; greatest error %.4f m",
                    accuracies[i], triangles, others[i], terrain.error());
            assertThat(triangles).isLessThanOrEqualTo((int) (1.2 * others[i]));
            assertThat(terrain.error()).isLessThanOrEqualTo(accuracies[i]);
        }
    }

    @Test
    void theSolidsOfDelftAreClosed() {
        Origin origin = Origin.at(Math.toRadians(52.0), Math.toRadians(4.37)).withHeight(0.0);
        LoadedBuildings city = new BuildingLoader(directory)
                .load(BuildingSettings.of("delft.city.json").withRadius(20_000), origin, Optional.empty());
        city.description().forEach(line -> print("%s", line));
        assertThat(city.count()).isEqualTo(160);
        assertThat(city.description()).anyMatch(line -> line.contains("160 solids had no floors, which were added"));
        assertThat(city.warnings()).noneMatch(line -> line.contains("is not closed"));
        assertThat(city.warnings()).noneMatch(line -> line.contains("crosses itself"));
        assertThat(openSides(city.mesh())).isEmpty();
    }

    /**
     * Sides of triangles that do not run as often one way as the other. Neighbours share vertices, so that a side of a
     * closed solid may belong to four triangles.
     */
    private static Map<Long, Integer> openSides(TriangleMesh mesh) {
        Map<Long, Integer> sides = new HashMap<>();
        for (int i = 0; i < mesh.triangleCount(); i++) {
            for (int k = 0; k < 3; k++) {
                int a = mesh.vertexIndex(i, k);
                int b = mesh.vertexIndex(i, (k + 1) % 3);
                sides.merge((long) Math.min(a, b) << 32 | Math.max(a, b), a < b ? 1 : -1, Integer::sum);
            }
        }
        sides.values().removeIf(sum -> sum == 0);
        return sides;
    }

    /**
     * Outlines of ways have 597,619.2 m2 by an independent computation; relations, which it left out, have the rest.
     */
    @Test
    void monacoHasItsArea() {
        Origin origin = Origin.at(Math.toRadians(43.7369557132469), Math.toRadians(7.422733173869995));
        LoadedBuildings loaded = new BuildingLoader(directory)
                .load(BuildingSettings.of("monaco.osm.gz").withRadius(4000), origin, Optional.empty());
        double ways = loaded.outlines().stream()
                .filter(outline -> outline.id().startsWith("way/"))
                .mapToDouble(GeoDataTest::area)
                .sum();
        print("Monaco: %d buildings, %.1f m2, of ways %.1f m2", loaded.count(), loaded.area(), ways);
        assertThat(ways).isCloseTo(597_619.2, within(1.0));
    }

    private static double area(BuildingOutline outline) {
        double area = Math.abs(Rings.signedArea(outline.outer()));
        for (double[] court : outline.courts()) {
            area -= Math.abs(Rings.signedArea(court));
        }
        return area;
    }

    /**
     * As a reader in another language counts them, which shares nothing with this one: 294 ways, two of which are not
     * closed, and 7 points.
     */
    @Test
    void andorraHasItsBuildings() {
        MapFeatures map = new MapFiles(directory).read("andorra.osm.pbf", new MapArea(-180, 180, -90, 90));
        long buildings = map.features().stream()
                .filter(feature ->
                        !feature.tags().getOrDefault("building", "no").equals("no"))
                .count();
        print(
                "Andorra: %d buildings of %d features; left out: %s",
                buildings, map.features().size(), map.leftOut());
        assertThat(buildings).isEqualTo(292);
        assertThat(map.leftOut()).containsEntry("point", 7);
    }

    /** A node turns the building by -90 degrees about x: 56.08 m wide, 63.36 m deep, and 9 m high. */
    @Test
    void aNodeTurnsItsBuildingUpright() {
        LoadedModel model = new ModelLoader(directory).load(ModelSettings.of("tm_no_indices_3storybuilding.glb"));
        AABB box = model.mesh().bounds();
        print("%s", model.describe());
        assertThat(box.maxX() - box.minX()).isCloseTo(56.08, within(0.01));
        assertThat(box.maxY() - box.minY()).isCloseTo(63.36, within(0.01));
        assertThat(box.maxZ() - box.minZ()).isCloseTo(9.0, within(0.01));
        assertThat(model.warnings()).isEmpty();
    }

    @Test
    void millimetresAreDoubted() {
        LoadedModel model = new ModelLoader(directory).load(ModelSettings.of("tm_20mm-xyz-cube.stl"));
        List<String> warnings = model.warnings();
        print("%s%n%s", model.describe(), warnings);
        assertThat(warnings).anyMatch(line -> line.contains("STL states no unit"));
    }
}
