package org.dronewatch.terrain;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.InputException;
import org.dronewatch.terrain.io.TiffFixture;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** From files to triangles in the world frame. */
class TerrainLoaderTest {
    private static final double X = 458_502.0;
    private static final double Y = 5_547_686.0;

    @TempDir
    private Path directory;

    /** A grid in UTM zone 33N whose posts are a metre apart and whose north-western post is at X, Y. */
    private static TiffFixture grid(int columns, int rows, IntToDoubleFunction height) {
        double[] samples = new double[columns * rows];
        for (int i = 0; i < samples.length; i++) {
            samples[i] = height.applyAsDouble(i);
        }
        TiffFixture fixture = new TiffFixture(columns, rows, samples);
        fixture.keys.put(1025, 2);
        fixture.scale = new double[] {1, 1, 0};
        fixture.tie = new double[] {0, 0, 0, X, Y, 0};
        return fixture;
    }

    /** The origin at a post, at height 0. */
    private static Origin at(double column, double row, double step) {
        MapTransform map =
                new MapTransform(CoordinateReferenceSystem.of("EPSG:32633"), Origin.at(Math.toRadians(50), 0.25));
        GeoPoint place = map.onEarth(X + column * step, Y - row * step, 0.0);
        return Origin.at(Math.toRadians(place.latitude()), Math.toRadians(place.longitude()))
                .withHeight(0.0);
    }

    private LoadedTerrain load(TerrainSettings settings, Origin origin) {
        return new TerrainLoader(directory, line -> {}).load(settings, origin);
    }

    private void write(String name, TiffFixture fixture) throws IOException {
        Files.write(directory.resolve(name), fixture.bytes());
    }

    /** The least height above a post at which a point is seen from above another post, m. */
    private static double leastHeight(
            World world, MapTransform map, double[] heights, int columns, int from, double above, int to) {
        Position observer = post(map, columns, from, heights[from] + above);
        double low = 0.0;
        double high = 100.0;
        Visibility visibility = new Visibility(world);
        if (sees(visibility, observer, post(map, columns, to, heights[to] + 1e-6))) {
            return 0.0;
        }
        while (high - low > 1e-6) {
            double middle = 0.5 * (low + high);
            if (sees(visibility, observer, post(map, columns, to, heights[to] + middle))) {
                high = middle;
            } else {
                low = middle;
            }
        }
        return high;
    }

    private static boolean sees(Visibility visibility, Position from, Position to) {
        return visibility.isFree(from.x(), from.y(), from.z(), to.x(), to.y(), to.z());
    }

    private static Position post(MapTransform map, int columns, int post, double height) {
        return map.inWorld(X + post % columns, Y - post / columns, height);
    }

    /**
     * A ridge 10 m high, seen from 2 m above the ground 30 m before it: by similar triangles, and as GDAL 3.10's
     * viewshed has it.
     */
    @Test
    void behindARidgeTheLeastVisibleHeightIsThatOfSimilarTriangles() throws IOException {
        TiffFixture ridge = grid(81, 41, i -> i % 81 == 50 ? 10.0 : 0.0);
        write("ridge.tif", ridge);
        Origin origin = at(20, 20, 1);
        World world = World.of(
                load(TerrainSettings.of("ridge.tif").withAccuracy(0), origin).mesh());
        MapTransform map = new MapTransform(CoordinateReferenceSystem.of("EPSG:32633"), origin);
        int[] columns = {40, 51, 60, 70, 80};
        double[] expected = {0.0, 10.2667, 12.6667, 15.3333, 18.0};
        for (int i = 0; i < columns.length; i++) {
            assertThat(leastHeight(world, map, ridge.samples, 81, 20 * 81 + 20, 2.0, 20 * 81 + columns[i]))
                    .as("column %d", columns[i])
                    .isEqualTo(expected[i], within(1e-3));
        }
    }

    /**
     * A pyramid, beside which a sight line depends on how squares are cut: along the north-west diagonal the least
     * heights are .4, 7.2 and 14.0 m; along the other they would be .1875, 5.647 and 12.21 m.
     */
    @Test
    void squaresAreCutAlongTheNorthWestDiagonal() throws IOException {
        TiffFixture pyramid =
                grid(61, 61, i -> Math.max(0.0, 20.0 - 2.0 * Math.max(Math.abs(i / 61 - 30), Math.abs(i % 61 - 30))));
        for (boolean southUp : new boolean[] {false, true}) {
            TiffFixture file = pyramid;
            if (southUp) {
                // The same posts, the southernmost row first: the diagonal is the same.
                file = grid(61, 61, i -> pyramid.samples[(60 - i / 61) * 61 + i % 61]);
                file.matrix = new double[] {1, 0, 0, X, 0, 1, 0, Y - 60, 0, 0, 0, 0, 0, 0, 0, 1};
            }
            write("pyramid.tif", file);
            Origin origin = at(5, 30, 1);
            World world = World.of(load(TerrainSettings.of("pyramid.tif").withAccuracy(0), origin)
                    .mesh());
            MapTransform map = new MapTransform(CoordinateReferenceSystem.of("EPSG:32633"), origin);
            int[] columns = {40, 50, 60};
            double[] expected = {0.4, 7.2, 14.0};
            for (int i = 0; i < columns.length; i++) {
                assertThat(leastHeight(world, map, pyramid.samples, 61, 30 * 61 + 5, 3.0, 10 * 61 + columns[i]))
                        .as("column %d, south up: %s", columns[i], southUp)
                        .isEqualTo(expected[i], within(1e-3));
            }
        }
    }

    /**
     * Flat ground on the round earth: from 2 m, a point 10 km away is seen at (d - sqrt(2 R h))^2 / 2R above the
     * ground, where R is the radius of curvature of the meridian or across it.
     */
    @ParameterizedTest
    @CsvSource({"0, 1", "1, 0"})
    void farGroundLiesBehindTheHorizon(int east, int north) throws IOException {
        double step = 100.0;
        int along = 111;
        int across = 5;
        int columns = east == 1 ? along : across;
        int rows = east == 1 ? across : along;
        TiffFixture flat = grid(columns, rows, i -> 0.0);
        flat.scale = new double[] {step, step, 0};
        write("flat.tif", flat);
        int column = east == 1 ? 2 : 2;
        int row = east == 1 ? 2 : rows - 3;
        Origin origin = at(column, row, step);
        World world =
                World.of(load(TerrainSettings.of("flat.tif").withAccuracy(0).withRadius(12_000), origin)
                        .mesh());
        double sin = Math.sin(origin.latitude());
        double e2 = 0.00669437999;
        double normal = 6_378_137.0 / Math.sqrt(1.0 - e2 * sin * sin);
        double radius = east == 1 ? normal : normal * (1.0 - e2) / (1.0 - e2 * sin * sin);
        double distance = 10_000.0;
        double expected = Math.pow(distance - Math.sqrt(2.0 * radius * 2.0), 2) / (2.0 * radius);
        double angle = distance / radius;
        double low = 0.0;
        double high = 10.0;
        Visibility visibility = new Visibility(world);
        while (high - low > 1e-6) {
            double middle = 0.5 * (low + high);
            double level = (radius + middle) * Math.sin(angle);
            double up = (radius + middle) * Math.cos(angle) - radius;
            boolean seen = visibility.isFree(0, 0, 2.0, east * level, north * level, up);
            low = seen ? low : middle;
            high = seen ? middle : high;
        }
        // Chords of 100 m lie 0.2 mm below the ground; a line along a grazing ray is 1 mm apart.
        assertThat(high).isEqualTo(expected, within(0.004));
        assertThat(expected).isBetween(1.90, 1.94);
    }

    /**
     * Along the equator, whose radius is that of the ellipsoid: posts 100 m apart, of which that at 5100 m hides most.
     * By GDAL 3.10's viewshed, which computes with this radius, 1.9197 m.
     */
    @Test
    void overTheEquatorGroundTenKilometresAwayIsSeenFromGdalsHeight() throws IOException {
        double radius = 6_378_137.0;
        double step = Math.toDegrees(100.0 / radius);
        TiffFixture flat = new TiffFixture(111, 5, new double[555]);
        flat.keys.put(1024, 2);
        flat.keys.put(1025, 2);
        flat.keys.put(2048, 4326);
        flat.keys.remove(3072);
        flat.scale = new double[] {step, step, 0};
        flat.tie = new double[] {0, 0, 0, 15.0 - 2.0 * step, 2.0 * step, 0};
        write("flat.tif", flat);
        Origin origin = Origin.at(0.0, Math.toRadians(15.0)).withHeight(0.0);
        LoadedTerrain terrain =
                load(TerrainSettings.of("flat.tif").withAccuracy(0).withRadius(12_000), origin);
        Visibility visibility = new Visibility(World.of(terrain.mesh()));
        double angle = 10_000.0 / radius;
        double low = 0.0;
        double high = 10.0;
        while (high - low > 1e-6) {
            double middle = 0.5 * (low + high);
            double level = (radius + middle) * Math.sin(angle);
            boolean seen = visibility.isFree(0, 0, 2.0, level, 0, (radius + middle) * Math.cos(angle) - radius);
            low = seen ? low : middle;
            high = seen ? middle : high;
        }
        assertThat(high).isEqualTo(1.9197, within(1e-4));
    }

    /** In float, northings of 5,547,686 m would be rounded to half metres; they are not. */
    @Test
    void nationalCoordinatesLoseNothing() throws IOException {
        TiffFixture slope = grid(30, 20, i -> 300.0 + 0.013 * i);
        slope.tie[3] += 0.37;
        write("slope.tif", slope);
        Origin origin = at(0, 0, 1).withHeight(300.0);
        TriangleMesh mesh =
                load(TerrainSettings.of("slope.tif").withAccuracy(0), origin).mesh();
        MapTransform map = new MapTransform(CoordinateReferenceSystem.of("EPSG:32633"), origin);
        assertThat(mesh.vertexCount()).isEqualTo(600);
        for (int i = 0; i < mesh.vertexCount(); i++) {
            Position exact = map.inWorld(X + 0.37 + i % 30, Y - i / 30, (float) slope.samples[i]);
            assertThat(mesh.vertexCoordinate(i, 0)).isEqualTo((float) exact.x(), within(2e-6F));
            assertThat(mesh.vertexCoordinate(i, 1)).isEqualTo((float) exact.y(), within(2e-6F));
            assertThat(mesh.vertexCoordinate(i, 2)).isEqualTo((float) exact.z(), within(2e-6F));
        }
        double[] normal = new double[3];
        for (int i = 0; i < mesh.triangleCount(); i++) {
            mesh.normal(i, normal);
            assertThat(normal[2]).as("triangle %d looks up", i).isPositive();
        }
    }

    /**
     * Two files whose outermost posts are a step apart have no gap between them; a third of three that is missing is a
     * hole.
     */
    @Test
    void filesMakeOneTerrainAndAMissingOneIsAHole() throws IOException {
        for (int k = 0; k < 3; k++) {
            int first = 20 * k;
            TiffFixture part = grid(20, 30, i -> 100.0 + 0.5 * (first + i % 20));
            part.tie[3] = X + first;
            write("part" + k + ".tif", part);
        }
        Origin origin = at(30, 15, 1);
        LoadedTerrain whole = load(
                TerrainSettings.of(List.of("part0.tif", "part1.tif", "part2.tif"))
                        .withAccuracy(0.001),
                origin);
        assertThat(whole.holes()).isZero();
        assertThat(whole.all()).isEqualTo(2 * 59 * 29);
        World world = World.of(whole.mesh());
        for (double x = -29.5; x < 29; x += 0.05) {
            assertThat(world.surfaceHeight(x, 0.2)).as("x = %f", x).isPresent();
        }
        LoadedTerrain broken =
                load(TerrainSettings.of(List.of("part0.tif", "part2.tif")).withAccuracy(0.001), origin);
        assertThat(broken.holes()).isEqualTo(20 * 30);
        assertThat(broken.all()).isEqualTo(2 * 2 * 19 * 29);
        World gap = World.of(broken.mesh());
        assertThat(gap.surfaceHeight(0.0, 0.2)).isEmpty();
        assertThat(gap.surfaceHeight(-20.0, 0.2)).isPresent();
        assertThat(gap.surfaceHeight(20.0, 0.2)).isPresent();
        assertThat(broken.warnings()).contains("terrain: there is no ground at the origin");
        assertThat(String.join("\n", broken.description())).contains("600 posts without heights (holes)");
    }

    /** The island of Taveuni lies on both sides of the date line, and so does its ground. */
    @Test
    void tilesMeetAtTheDateLine() throws IOException {
        for (double west : new double[] {179.99, -180.0}) {
            TiffFixture tile = grid(101, 101, i -> 40.0);
            tile.keys.remove(3072);
            tile.keys.put(2048, 4326);
            tile.scale = new double[] {1e-4, 1e-4, 0};
            tile.tie = new double[] {0, 0, 0, west, -16.795, 0};
            write(west > 0 ? "west.tif" : "east.tif", tile);
        }
        for (double longitude : new double[] {179.9999, -179.9999}) {
            Origin origin =
                    Origin.at(Math.toRadians(-16.8), Math.toRadians(longitude)).withHeight(0.0);
            for (List<String> files : List.of(List.of("west.tif", "east.tif"), List.of("east.tif", "west.tif"))) {
                LoadedTerrain both = load(TerrainSettings.of(files).withRadius(400), origin);
                assertThat(both.holes()).isZero();
                World world = World.of(both.mesh());
                for (double x = -390.0; x <= 390.0; x += 13.0) {
                    assertThat(world.surfaceHeight(x, 1.0).orElseThrow()).isEqualTo(40.0, within(0.05));
                }
            }
        }
    }

    /** Where files overlap the first one counts that has a height. */
    @Test
    void theFirstFileWithAHeightCounts() throws IOException {
        TiffFixture first = grid(10, 10, i -> i % 10 == 4 ? -9999 : 1.0);
        first.nodata = "-9999";
        write("first.tif", first);
        write("second.tif", grid(10, 10, i -> 2.0));
        LoadedTerrain both =
                load(TerrainSettings.of(List.of("first.tif", "second.tif")).withAccuracy(0), at(5, 5, 1));
        assertThat(both.holes()).isZero();
        World world = World.of(both.mesh());
        assertThat(world.surfaceHeight(-1.0, 0.1).orElseThrow()).isEqualTo(2.0, within(0.02));
        assertThat(world.surfaceHeight(2.5, 0.1).orElseThrow()).isEqualTo(1.0, within(1e-3));
    }

    @Test
    void filesOfDifferentGridsAreRefused() throws IOException {
        write("fine.tif", grid(20, 20, i -> 1.0));
        TiffFixture coarse = grid(20, 20, i -> 1.0);
        coarse.scale = new double[] {2, 2, 0};
        write("coarse.tif", coarse);
        TiffFixture shifted = grid(20, 20, i -> 1.0);
        shifted.tie[3] += 0.5;
        write("shifted.tif", shifted);
        TiffFixture other = grid(20, 20, i -> 1.0);
        other.keys.put(3072, 32632);
        write("other.tif", other);
        Origin origin = at(5, 5, 1);
        assertThatThrownBy(() -> load(TerrainSettings.of(List.of("fine.tif", "coarse.tif")), origin))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(
                        "coarse.tif: its posts, 2.00000000 x 2.00000000 apart, are not those of the grid of fine.tif")
                .hasMessageContaining("gdalwarp -tr");
        assertThatThrownBy(() -> load(TerrainSettings.of(List.of("fine.tif", "shifted.tif")), origin))
                .hasMessageContaining("shifted.tif: its posts");
        assertThatThrownBy(() -> load(TerrainSettings.of(List.of("fine.tif", "other.tif")), origin))
                .hasMessageContaining("other.tif: is in EPSG:32632, but fine.tif is in EPSG:32633")
                .hasMessageContaining("gdalwarp -t_srs EPSG:32633");
    }

    @Test
    void aFileWithoutASystemAsksForOne() throws IOException {
        TiffFixture none = grid(20, 20, i -> 1.0);
        none.keys.clear();
        write("none.tif", none);
        assertThatThrownBy(() -> load(TerrainSettings.of("none.tif"), at(5, 5, 1)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("does not state its coordinate reference system")
                .hasMessageContaining("crs: EPSG:");
        assertThat(load(TerrainSettings.of("none.tif").withCrs("EPSG:32633"), at(5, 5, 1))
                        .posts())
                .isEqualTo(400);
        // Another datum would put it elsewhere, and the user's word counts; a line says so.
        TiffFixture own = grid(20, 20, i -> 1.0);
        write("own.tif", own);
        assertThat(load(TerrainSettings.of("own.tif").withCrs("EPSG:25833"), at(5, 5, 1))
                        .warnings())
                .contains("own.tif: states EPSG:32633, but is read as EPSG:25833 (world.terrain.crs)");
        // A code that is not known is replaced likewise, as the message without crs says.
        own.keys.put(3072, 9999);
        write("odd.tif", own);
        assertThatThrownBy(() -> load(TerrainSettings.of("odd.tif"), at(5, 5, 1)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("'EPSG:9999' is not known")
                .hasMessageEndingWith("; world.terrain.crs can name another");
        assertThat(load(TerrainSettings.of("odd.tif").withCrs("EPSG:32633"), at(5, 5, 1))
                        .warnings())
                .contains("odd.tif: states EPSG:9999, but is read as EPSG:32633 (world.terrain.crs)");
    }

    /** Long Island's grid is in US survey feet; its heights may be in metres all the same. */
    @Test
    void heightsWithoutAUnitOnAGridInFeetAreDoubted() throws IOException {
        TiffFixture feet = grid(20, 20, i -> 100.0);
        feet.keys.put(3072, 2263);
        feet.tie = new double[] {0, 0, 0, 981_000, 199_000, 0};
        feet.scale = new double[] {30, 30, 0};
        GeoPoint place = new MapTransform(CoordinateReferenceSystem.of("EPSG:2263"), Origin.at(0.71, -1.29))
                .onEarth(981_300, 198_700, 0.0);
        Origin origin = Origin.at(Math.toRadians(place.latitude()), Math.toRadians(place.longitude()));
        write("silent.tif", feet);
        String doubt = "EPSG:2263 is a grid in feet, but the unit of the heights is not stated";
        assertThat(load(TerrainSettings.of("silent.tif"), origin).warnings())
                .filteredOn(line -> line.contains(doubt))
                .singleElement()
                .asString()
                .startsWith("silent.tif: ")
                .contains("gdal_translate -a_srs EPSG:2263+6360");
        feet.keys.put(4096, 5703);
        write("metres.tif", feet);
        assertThat(load(TerrainSettings.of("metres.tif"), origin).warnings()).noneMatch(line -> line.contains(doubt));
        feet.keys.remove(4096);
        feet.keys.put(4099, 9001);
        write("units.tif", feet);
        assertThat(load(TerrainSettings.of("units.tif"), origin).warnings()).noneMatch(line -> line.contains(doubt));
    }

    @Test
    void theRadiusCutsAndWhatIsFarAwayIsRefused() throws IOException {
        write("dem.tif", grid(100, 80, i -> 5.0));
        LoadedTerrain part = load(TerrainSettings.of("dem.tif").withRadius(10).withAccuracy(0), at(50, 40, 1));
        assertThat(part.posts()).isBetween(21 * 21, 23 * 23);
        assertThatThrownBy(() -> load(TerrainSettings.of("dem.tif").withRadius(10), at(500, 40, 1)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("no posts within 10.0 m of the origin")
                .hasMessageContaining(
                        "it covers 458502.0 to 458601.0 east and 5547607.0 to 5547686.0 north in EPSG:32633, latitude ")
                // Its north-west corner, by PROJ.
                .hasMessageContaining(" to 50.08000 and longitude 14.42000 to ");
    }

    /** A terrain beside the origin: its limits are on the same side. */
    @Test
    void aTerrainBesideTheOriginHasNoNegativeExtent() throws IOException {
        write("dem.tif", grid(100, 80, i -> 5.0));
        LoadedTerrain beside = load(TerrainSettings.of("dem.tif").withAccuracy(0), at(150, 40, 1));
        assertThat(beside.description())
                .anyMatch(line ->
                        line.startsWith("terrain: extends from 0.15 km west to 0.05 km west and from 0.04 km south to"
                                + " 0.04 km north of the origin, which lies outside; "));
        assertThat(beside.warnings()).contains("terrain: there is no ground at the origin");
    }

    @Test
    void moreThanTwentyFiveMillionPostsAreRefused() throws IOException {
        String header = "ncols 6000\nnrows 6000\nxllcenter 458502\nyllcenter 5541687\ncellsize 1\n";
        try (RandomAccessFile file =
                new RandomAccessFile(directory.resolve("large.asc").toFile(), "rw")) {
            file.write(header.getBytes(StandardCharsets.US_ASCII));
            file.setLength(2L * 6000 * 6000);
        }
        assertThatThrownBy(() -> load(
                        TerrainSettings.of("large.asc").withCrs("EPSG:32633").withRadius(4000), at(3000, 3000, 1)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining(
                        "6,000 x 6,000 posts within 4000.0 m of the origin; there must be at most 25,000,000")
                .hasMessageContaining("smaller radius");
    }

    /** 0 m is a height like others; -32768, -9999 and 3.4e38 that no tag states are holes, and a line says so. */
    @Test
    void heightsThatAreNotOnEarthAreHoles() throws IOException {
        double[] odd = {-32768, -9999, 3.4e38, -3.4e38, Double.NaN, 0.0, 9500, 8000};
        TiffFixture file = grid(20, 20, i -> i < odd.length ? odd[i] : 10.0);
        write("odd.tif", file);
        LoadedTerrain terrain = load(TerrainSettings.of("odd.tif").withAccuracy(0), at(10, 10, 1));
        assertThat(terrain.holes()).isEqualTo(6);
        assertThat(terrain.warnings()).anyMatch(line -> line.startsWith("terrain: 5 posts have impossible heights"));
        TiffFixture sea = grid(20, 20, i -> i < 100 ? 0.0 : 10.0);
        write("sea.tif", sea);
        LoadedTerrain asGround = load(TerrainSettings.of("sea.tif"), at(10, 10, 1));
        assertThat(asGround.holes()).isZero();
        assertThat(asGround.warnings())
                .anyMatch(line -> line.contains("100 of 400 posts are exactly 0 m high")
                        && line.contains("world.terrain.nodata: 0"));
        assertThat(load(TerrainSettings.of("sea.tif").withNodata(0.0), at(10, 10, 1))
                        .holes())
                .isEqualTo(100);
    }

    @Test
    void surfaceModelsAreDoubted() throws IOException {
        write("Copernicus_DSM_10.tif", grid(20, 20, i -> 10.0));
        assertThat(load(TerrainSettings.of("Copernicus_DSM_10.tif"), at(10, 10, 1))
                        .warnings())
                .anyMatch(line -> line.contains("roofs and treetops") && line.contains("surface: dsm"));
        assertThat(load(TerrainSettings.of("Copernicus_DSM_10.tif").withSurface(ElevationSurface.DSM), at(10, 10, 1))
                        .warnings())
                .isEmpty();
    }

    @Test
    void whereElevationsComeFromIsShown() throws IOException {
        write("Copernicus_DSM_10.tif", grid(20, 20, i -> 10.0));
        TerrainSettings settings = TerrainSettings.of("Copernicus_DSM_10.tif").withSurface(ElevationSurface.DSM);
        assertThat(load(settings, at(10, 10, 1)).description())
                .as("the notice that the licence of the Copernicus DEM requires")
                .anyMatch(line -> line.startsWith("elevations: produced using Copernicus WorldDEM-30 \u00a9 DLR e.V."));
        assertThat(load(settings.withAttribution("Survey of Freedonia,\nlicence 7"), at(10, 10, 1))
                        .description())
                .contains("elevations: Survey of Freedonia, licence 7")
                .noneMatch(line -> line.contains("Copernicus WorldDEM"));
        write("own.tif", grid(20, 20, i -> 10.0));
        assertThat(load(TerrainSettings.of("own.tif"), at(10, 10, 1)).description())
                .noneMatch(line -> line.startsWith("elevations:"));
        assertThatThrownBy(() -> settings.withAttribution("x".repeat(301)))
                .hasMessage("attribution has 301 characters but must have 1 to 300");
        assertThatThrownBy(() -> settings.withAttribution(" "))
                .hasMessage("attribution has 0 characters but must have 1 to 300");
    }

    /** z counts from the origin's height, and from the file's level where the origin has none; an offset moves both. */
    @Test
    void heightsCountFromTheOrigin() throws IOException {
        write("dem.tif", grid(20, 20, i -> 250.0));
        Origin origin = at(10, 10, 1);
        TerrainSettings settings = TerrainSettings.of("dem.tif");
        assertThat(ground(settings, origin.withHeight(240.0))).isEqualTo(10.0, within(1e-4));
        assertThat(ground(settings, origin.withHeight(0.0))).isEqualTo(250.0, within(1e-4));
        assertThat(ground(settings, Origin.at(origin.latitude(), origin.longitude())))
                .isEqualTo(250.0, within(1e-4));
        assertThat(ground(settings.withVerticalOffset(-45.0), origin.withHeight(240.0)))
                .isEqualTo(-35.0, within(1e-4));
        assertThat(load(settings, origin.withHeight(240.0)).description())
                .anyMatch(line -> line.contains("250.0 m at the origin (z = 10.0 m)"));
    }

    private double ground(TerrainSettings settings, Origin origin) {
        return World.of(load(settings, origin).mesh()).surfaceHeight(0.1, 0.1).orElseThrow();
    }

    @Test
    void theSameFilesGiveTheSameTriangles() throws IOException {
        write("dem.tif", grid(60, 50, i -> 20.0 * Math.sin(0.1 * (i % 60)) * Math.cos(0.2 * (i / 60))));
        LoadedTerrain one = load(TerrainSettings.of("dem.tif").withAccuracy(0.3), at(30, 20, 1));
        LoadedTerrain two = load(TerrainSettings.of("dem.tif").withAccuracy(0.3), at(30, 20, 1));
        assertThat(one.mesh().triangleCount()).isEqualTo(two.mesh().triangleCount());
        for (int i = 0; i < one.mesh().triangleCount(); i++) {
            for (int k = 0; k < 9; k++) {
                assertThat(one.mesh().coordinate(i, k / 3, k % 3))
                        .isEqualTo(two.mesh().coordinate(i, k / 3, k % 3));
            }
        }
        assertThat(one.error()).isLessThanOrEqualTo(0.3);
        assertThat(one.files().get(0).file()).isEqualTo("dem.tif");
    }
}
