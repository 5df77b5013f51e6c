package org.dronewatch.buildings;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.setting.InputException;
import org.dronewatch.terrain.TerrainGround;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Solids of outlines that are drawn in metres about an origin, with areas and volumes worked out by hand. */
class BuildingLoaderTest {
    private static final Origin ORIGIN =
            Origin.at(Math.toRadians(50.0), Math.toRadians(15.0)).withHeight(200.0);
    private static final double FLOOR = BuildingLoader.BELOW;

    @TempDir
    private Path directory;

    private final DrawnMap map = new DrawnMap(ORIGIN);

    /** A rectangle from one corner to the opposite one, m. */
    private static double[] box(double fromX, double fromY, double toX, double toY) {
        return new double[] {fromX, fromY, toX, fromY, toX, toY, fromX, toY};
    }

    private int way(double[] ring, String tags) {
        return map.area(ring, tags);
    }

    private void relation(String members, String tags) {
        map.relation(members, tags);
    }

    private LoadedBuildings load() throws IOException {
        return load(BuildingSettings.of("map.osm"), Optional.empty());
    }

    private LoadedBuildings load(BuildingSettings settings, Optional<TerrainGround> terrain) throws IOException {
        Files.writeString(directory.resolve("map.osm"), map.osm());
        return new BuildingLoader(directory).load(settings, ORIGIN, terrain);
    }

    /** Positive if the triangles face outwards, m3. */
    static double volume(TriangleMesh mesh) {
        double sixfold = 0.0;
        for (int i = 0; i < mesh.triangleCount(); i++) {
            Position a = corner(mesh, i, 0);
            Position b = corner(mesh, i, 1);
            Position c = corner(mesh, i, 2);
            sixfold += a.x() * (b.y() * c.z() - b.z() * c.y())
                    + a.y() * (b.z() * c.x() - b.x() * c.z())
                    + a.z() * (b.x() * c.y() - b.y() * c.x());
        }
        return sixfold / 6.0;
    }

    private static Position corner(TriangleMesh mesh, int triangle, int corner) {
        return new Position(
                mesh.coordinate(triangle, corner, 0),
                mesh.coordinate(triangle, corner, 1),
                mesh.coordinate(triangle, corner, 2));
    }

    /** Each side of a triangle is a side of exactly one other, the other way around. */
    static void assertClosed(TriangleMesh mesh) {
        Map<String, Integer> sides = new HashMap<>();
        for (int i = 0; i < mesh.triangleCount(); i++) {
            for (int k = 0; k < 3; k++) {
                int a = mesh.vertexIndex(i, k);
                int b = mesh.vertexIndex(i, (k + 1) % 3);
                sides.merge(Math.min(a, b) + "-" + Math.max(a, b), a < b ? 1 : -1, Integer::sum);
                sides.merge("count " + Math.min(a, b) + "-" + Math.max(a, b), 1, Integer::sum);
            }
        }
        assertThat(sides).allSatisfy((side, sum) -> assertThat(sum).as(side).isEqualTo(side.startsWith("c") ? 2 : 0));
    }

    private static double highest(TriangleMesh mesh) {
        double highest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < mesh.vertexCount(); i++) {
            highest = Math.max(highest, mesh.vertexCoordinate(i, 2));
        }
        return highest;
    }

    /**
     * 20 m x 10 m, 12 m high with its roof, of which the roof is 4 m where it has slopes; walls go 1 m into the ground.
     * Over the eaves: a gable half of the box; a hip two wedges less 1/3 of each end; a pyramid a third; a single slope
     * half.
     */
    @ParameterizedTest
    @CsvSource({
        "flat, 12, 2600",
        "gabled, 12, 2200",
        "hipped, 12, 2133.3333",
        "pyramidal, 12, 2066.6667",
        "skillion, 12, 2200",
    })
    void roofsHaveTheVolumesWorkedOutByHand(String shape, double top, double volume) throws IOException {
        way(box(30, 40, 50, 50), "building=yes height=12 roof:shape=" + shape + " roof:height=4");
        LoadedBuildings loaded = load();

        assertClosed(loaded.mesh());
        assertThat(loaded.area()).isCloseTo(200.0, within(1e-3));
        assertThat(volume(loaded.mesh())).isCloseTo(volume, within(0.05));
        assertThat(highest(loaded.mesh())).isCloseTo(top, within(1e-3));
        assertThat(loaded.warnings()).isEmpty();
    }

    /**
     * Corners that are rounded as maps round them: where slopes meet the eaves lies less than a millimetre beside a
     * corner.
     */
    @Test
    void almostRectanglesHaveTheirRoofs() throws IOException {
        long seed = 11L;
        Random random = new Random(seed);
        double expected = 0.0;
        for (int i = 0; i < 200; i++) {
            double angle = random.nextDouble() * Math.PI;
            double width = 6 + 6 * random.nextDouble();
            double length = width + 10 * random.nextDouble();
            double x = 60.0 * (i % 15) - 450;
            double y = 60.0 * (i / 15) - 450;
            double[] ring = box(0, 0, length, width);
            for (int k = 0; k < 8; k += 2) {
                double u = ring[k];
                double v = ring[k + 1];
                ring[k] = x + u * Math.cos(angle) - v * Math.sin(angle) + 0.01 * random.nextDouble();
                ring[k + 1] = y + u * Math.sin(angle) + v * Math.cos(angle) + 0.01 * random.nextDouble();
            }
            String shape = new String[] {"hipped", "gabled", "pyramidal", "skillion"}[i % 4];
            way(ring, "building=yes height=10 roof:height=3 roof:shape=" + shape);
            double over = i % 4 == 0
                    ? 3.0 * (length * width / 2 - width * width / 6)
                    : length * width * (i % 4 == 2 ? 1.0 : 1.5);
            expected += 8.0 * length * width + over;
        }
        LoadedBuildings loaded = load();
        assertThat(loaded.warnings()).as("seed %d", seed).isEmpty();
        assertClosed(loaded.mesh());
        assertThat(volume(loaded.mesh())).isCloseTo(expected, within(0.005 * expected));
    }

    /** Over an octagon a dome of half its width: six frustums, whose sides are chords of a quarter circle. */
    @Test
    void aDomeIsMadeOfRings() throws IOException {
        double[] ring = new double[16];
        for (int i = 0; i < 8; i++) {
            ring[2 * i] = 5.0 * Math.cos(Math.PI * i / 4);
            ring[2 * i + 1] = 5.0 * Math.sin(Math.PI * i / 4);
        }
        way(ring, "building=yes height=15 roof:shape=dome roof:height=5");
        LoadedBuildings loaded = load();
        double area = 2.0 * Math.sqrt(2.0) * 25.0;
        double expected = area * (10.0 + FLOOR);
        for (int k = 0; k < RoofPlanes.RINGS_OF_A_DOME; k++) {
            double from = 0.5 * Math.PI * k / RoofPlanes.RINGS_OF_A_DOME;
            double to = 0.5 * Math.PI * (k + 1) / RoofPlanes.RINGS_OF_A_DOME;
            double a = Math.cos(from);
            double b = Math.cos(to);
            expected += area * 5.0 * (Math.sin(to) - Math.sin(from)) * (a * a + a * b + b * b) / 3.0;
        }
        assertClosed(loaded.mesh());
        assertThat(volume(loaded.mesh())).isCloseTo(expected, within(0.05));
    }

    /** The ridge of an L is that of the rectangle about it; its arm of 10 m x 10 m lies wholly under one slope. */
    @Test
    void aGableOverAnLIsCutAlongItsRidge() throws IOException {
        way(
                new double[] {0, 0, 30, 0, 30, 20, 20, 20, 20, 10, 0, 10},
                "building=yes height=11 roof:shape=gabled roof:height=5");
        LoadedBuildings loaded = load();

        assertClosed(loaded.mesh());
        // South of the ridge at y = 10, mean 2.5 m over 300 m2; north of it the same over 100 m2.
        assertThat(volume(loaded.mesh())).isCloseTo(400 * 7 + 400 * 2.5, within(0.05));
    }

    @ParameterizedTest
    @CsvSource({
        "roof:direction=S, 20, 0.5",
        "roof:direction=270, 0.5, 20",
        "'', 20, 0.5",
        "roof:orientation=across, 0.5, 5"
    })
    void aSingleSlopeFallsWhereTheMapSays(String tag, double lowX, double lowY) throws IOException {
        way(box(0, 0, 40, 10), "building=yes height=12 roof:shape=skillion roof:height=4 " + tag);
        TriangleMesh mesh = load().mesh();

        double lowest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < mesh.vertexCount(); i++) {
            double z = mesh.vertexCoordinate(i, 2);
            boolean isNear = Math.abs(mesh.vertexCoordinate(i, 0) - lowX) < 21
                    && Math.abs(mesh.vertexCoordinate(i, 1) - lowY) < (lowY > 1 ? 21 : 1);
            if (z > 0.0) {
                lowest = Math.min(lowest, z);
                assertThat(isNear || z > 11.9).as("corner %d at %s m", i, z).isTrue();
            }
        }
        assertThat(lowest).isCloseTo(8.0, within(1e-3));
    }

    @ParameterizedTest
    @CsvSource({
        "height=12, 12, 0",
        "height=5.234123456789, 5.234123, 0",
        "height=5.00000000000000044408920985006, 5, 0",
        "'height=9,123456789012~m', 9.123457, 0",
        "height=39.370078740157481~ft, 12, 0",
        "building:levels=3.3333333333333335, 10, 0",
        "height=5.~m, 9, 1",
        "height=12~m, 12, 0",
        "'height=9,5', 9.5, 0",
        "height=40~ft, 12.192, 0",
        "height=39&apos;4&quot;, 11.9888, 0",
        "height=39&apos;, 11.8872, 0",
        "building:levels=4, 12, 0",
        "building:levels=2.5, 7.5, 0",
        "building:levels=4 roof:shape=gabled roof:levels=1, 15, 0",
        "building:levels=4 roof:shape=gabled roof:angle=45, 17, 0",
        "height=tall, 9, 1",
        "height=-3 building:levels=2, 6, 0",
        "min_height=20, 29, 1",
        "'', 9, 1",
    })
    void heightsAreReadWithTheirUnits(String tags, double top, int assumed) throws IOException {
        way(box(0, 0, 20, 10), ("building=yes " + tags).strip());
        LoadedBuildings loaded = load();

        assertThat(highest(loaded.mesh())).isCloseTo(top, within(1e-3));
        assertThat(loaded.assumed()).isEqualTo(assumed);
        assertThat(loaded.mesh().materialNames())
                .containsExactly(assumed == 1 ? "brick_rendered:assumed-height" : "brick_rendered");
    }

    /**
     * 40 m x 10 m, the eaves at 12 m, at 30 degrees: half the way across the ridge, or all of it for a single slope,
     * times tan 30. Hips of one pitch all round end at the middle of the shorter side. At 45 degrees to the walls the
     * house is 50 / sqrt 2 m wide.
     */
    @ParameterizedTest
    @CsvSource({
        "gabled, '', 14.88675",
        "gabled, roof:orientation=along, 14.88675",
        "gabled, roof:orientation=across, 23.54701",
        "gabled, roof:direction=E, 23.54701",
        "gabled, roof:direction=180, 14.88675",
        "gabled, roof:direction=45, 22.20621",
        "skillion, '', 17.77350",
        "skillion, roof:orientation=across, 35.09401",
        "skillion, roof:direction=W, 35.09401",
        "hipped, roof:orientation=across, 14.88675",
        "pyramidal, roof:orientation=across, 14.88675",
    })
    void theAngleOfARoofIsMeasuredAcrossItsRidge(String shape, String ridge, double top) throws IOException {
        way(
                box(0, 0, 40, 10),
                ("building=yes building:levels=4 roof:angle=30 roof:shape=" + shape + " " + ridge).strip());
        LoadedBuildings loaded = load();
        assertThat(highest(loaded.mesh())).isCloseTo(top, within(1e-3));
        assertThat(loaded.warnings()).isEmpty();
        assertClosed(loaded.mesh());
    }

    /** What is counted as stated is what was used. */
    @Test
    void aHeightThatCannotBeUsedIsNotStatedWhereLevelsAre() throws IOException {
        way(box(0, 0, 20, 10), "building=yes height=about~12 building:levels=4");
        way(box(30, 0, 50, 10), "building=yes height=high building:height=7");
        way(box(60, 0, 80, 10), "building=yes height=7 building:levels=4");
        way(box(90, 0, 99, 10), "building=yes height=high");
        assertThat(load().description())
                .anyMatch(line -> line.contains("heights: 2 stated, 1 from levels of 3 m, 1 assumed to be 9 m"));
    }

    /** No corner lies within 100 m of the origin: a hall is over it, a bar crosses the rim, a ring is round it. */
    @ParameterizedTest
    @CsvSource({
        "-145 -145 145 145, '', 1",
        "-300 60 300 80, '', 1",
        "-300 101 300 120, '', 0",
        "-145 -145 145 145, -120 -120 120 120, 0",
        "-145 -145 145 145, -120 -120 120 99, 1",
        "-145 -145 145 145, 0 -20 20 20, 1",
        "110 -20 145 20, '', 0",
        "110 -300 145 300, '', 0",
    })
    void whatLiesPartlyWithinTheRadiusIsIncluded(String outline, String court, int count) throws IOException {
        way(box(50, 0, 60, 10), "building=yes height=5");
        for (String tags : new String[] {"building=yes height=9", "natural=wood"}) {
            int outer = way(box(outline), "");
            String members = court.isEmpty() ? "" : " inner=" + way(box(court), "");
            relation("outer=" + outer + members, "type=multipolygon " + tags);
        }
        BuildingSettings settings =
                BuildingSettings.of("map.osm").withRadius(100).withWoodHeight(15);
        LoadedBuildings loaded = load(settings, Optional.empty());
        assertThat(loaded.count()).isEqualTo(1 + count);
        assertThat(loaded.woods().triangleCount() > 0).isEqualTo(count == 1);
    }

    private static double[] box(String corners) {
        String[] at = corners.split(" ");
        return box(
                Double.parseDouble(at[0]),
                Double.parseDouble(at[1]),
                Double.parseDouble(at[2]),
                Double.parseDouble(at[3]));
    }

    /** From the second of five levels of 3 m up, over 200 m2; a stated height or least height counts before levels. */
    @ParameterizedTest
    @CsvSource({
        "building:levels=5 building:min_level=2, 6, 15",
        "building:levels=5 building:min_level=2 min_height=5, 5, 15",
        "height=14 building:min_level=2, 6, 14",
        "building:levels=5 building:min_level=0, -1, 15",
    })
    void aPartBeginsAtItsLowestLevel(String tags, double bottom, double top) throws IOException {
        way(box(0, 0, 20, 10), "building=yes " + tags);
        LoadedBuildings loaded = load();
        assertThat(lowest(loaded.mesh())).isCloseTo(bottom, within(1e-3));
        assertThat(highest(loaded.mesh())).isCloseTo(top, within(1e-3));
        assertThat(volume(loaded.mesh())).isCloseTo(200.0 * (top - bottom), within(0.2));
        assertClosed(loaded.mesh());
    }

    private static double lowest(TriangleMesh mesh) {
        double lowest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < mesh.vertexCount(); i++) {
            lowest = Math.min(lowest, mesh.vertexCoordinate(i, 2));
        }
        return lowest;
    }

    @Test
    void whatCannotBeReadIsNamed() throws IOException {
        way(box(0, 0, 20, 10), "building=yes height=tall roof:shape=onion");
        assertThat(load().warnings())
                .anyMatch(line -> line.equals("map.osm: not used: height=tall: way/1001"))
                .anyMatch(line -> line.equals("map.osm: not used: roof:shape=onion: way/1001"));
    }

    /** 889 of 889 without a height is another matter than a height that is not understood. */
    @Test
    void aHeightThatCannotBeUsedIsNotNone() throws IOException {
        way(box(0, 0, 20, 10), "building=yes height=12;15");
        way(box(30, 0, 50, 10), "building=yes");
        way(box(60, 0, 80, 10), "building=yes building:levels=many");
        way(box(90, 0, 99, 10), "building=yes height=7");
        assertThat(load().warnings())
                .contains(
                        "map.osm: 3 of 4 buildings have no height in the map, or one that cannot be used (2): 9 m is assumed"
                                + " (world.buildings.height)");
    }

    /** Built as far as the building is high; the warning names what the map states. */
    @ParameterizedTest
    @CsvSource({
        "height=5 roof:shape=gabled roof:height=50, true",
        "height=8 min_height=3 roof:shape=gabled roof:height=5, false",
        "height=8.1 min_height=3.14 roof:shape=gabled roof:height=5, false",
        "height=4 roof:shape=pyramidal roof:levels=2, true",
        "height=4 roof:shape=gabled roof:angle=60, true",
        "height=2.5 roof:shape=gabled, false",
        "building:levels=1 roof:shape=gabled roof:height=50, false",
        "height=5 roof:height=50, false",
    })
    void aRoofHigherThanItsBuildingIsDoubted(String tags, boolean isDoubted) throws IOException {
        way(box(0, 0, 20, 10), "building=yes " + tags);
        String stated = tags.replaceFirst(".*(roof:(?:height|levels|angle)=\\d+).*", "$1");
        assertThat(load().warnings().stream()
                        .filter(line -> line.contains("roof cut"))
                        .toList())
                .isEqualTo(
                        isDoubted
                                ? List.of("map.osm: roof cut to the height of the building: " + stated + ": way/1001")
                                : List.of());
    }

    /** 9 m in centimetres; 111 West 57th Street in New York is 435 m high and 18 m wide, and chimneys are slender. */
    @ParameterizedTest
    @CsvSource({
        "900, 18, 'height of 900 m, more than that of almost any building'",
        "501, 60, 'height of 501 m, more than that of almost any building'",
        "450, 14, 'height of 450 m, more than 30 times the width'",
        "435, 18, ''",
        "90, 1, ''",
        "500, 60, ''",
    })
    void anImplausibleHeightIsDoubted(double height, double width, String doubt) throws IOException {
        way(box(0, 0, 80, width), "building=yes height=" + height);
        LoadedBuildings loaded = load();
        assertThat(highest(loaded.mesh())).isCloseTo(height, within(0.01));
        assertThat(loaded.warnings())
                .isEqualTo(doubt.isEmpty() ? List.of() : List.of("map.osm: " + doubt + ": way/1001"));
    }

    @Test
    void heightZeroIsAHeight() throws IOException {
        way(box(0, 0, 20, 10), "building=yes height=0");
        way(box(30, 0, 50, 10), "building=yes height=5");
        LoadedBuildings loaded = load();
        assertThat(loaded.count()).isEqualTo(1);
        assertThat(loaded.description()).anyMatch(line -> line.contains("left out: 1 building of no height"));
    }

    /** The outline of 400 m2 is 30 m high; its parts are a hall and, on its half, a tower. */
    @Test
    void partsReplaceTheOutlineThatTheyCover() throws IOException {
        way(box(0, 0, 20, 20), "building=yes height=30");
        way(box(0, 0, 20, 10), "building:part=yes height=10");
        way(box(0, 10, 20, 20), "building:part=yes height=30");
        way(box(0, 0, 20, 10), "building:part=yes height=22 min_height=20");
        LoadedBuildings loaded = load();

        assertThat(loaded.count()).isEqualTo(3);
        // Parts on the ground reach into it, that in the air does not.
        assertThat(volume(loaded.mesh())).isCloseTo(200 * 11 + 200 * 31 + 200 * 2, within(0.1));
        assertThat(loaded.description().get(0)).contains("0 buildings and 3 parts");
    }

    @Test
    void anOutlineThatPartsCoverOnlyInPartStays() throws IOException {
        way(box(0, 0, 20, 20), "building=yes height=10");
        way(box(0, 0, 10, 10), "building:part=yes height=30");
        LoadedBuildings loaded = load();
        assertThat(volume(loaded.mesh())).isCloseTo(400 * 11 + 100 * 31, within(0.1));
        assertThat(loaded.warnings()).anyMatch(line -> line.contains("parts cover less than nine tenths"));
    }

    /** A court of 10 m x 10 m, and the outline in two ways that are joined. */
    @Test
    void aMultipolygonHasItsCourtyard() throws IOException {
        int outer = way(box(0, 0, 30, 30), "");
        int inner = way(box(10, 10, 20, 20), "");
        relation("outer=" + outer + " inner=" + inner, "type=multipolygon building=yes height=9");
        LoadedBuildings loaded = load();
        assertClosed(loaded.mesh());
        assertThat(loaded.area()).isCloseTo(800.0, within(1e-2));
        assertThat(volume(loaded.mesh())).isCloseTo(8000.0, within(0.2));
    }

    @Test
    void whatIsUndergroundIsLeftOut() throws IOException {
        way(box(0, 0, 20, 10), "building=yes location=underground");
        way(box(30, 0, 50, 10), "building=yes layer=-1 height=5");
        LoadedBuildings loaded = load();
        assertThat(loaded.count()).isEqualTo(1);
        assertThat(loaded.description()).anyMatch(line -> line.contains("left out: 1 building underground"));
    }

    /** A roof without walls is a slab. */
    @Test
    void anOpenRoofHasNoWalls() throws IOException {
        way(box(0, 0, 20, 10), "building=roof height=5");
        assertThat(volume(load().mesh())).isCloseTo(200 * 0.3, within(0.01));
    }

    /** The ground rises 1 m in 10 m to the east, and the house is 20 m long. */
    @Test
    void onASlopeHeightsCountFromTheLowestGround() throws IOException {
        way(box(30, 0, 50, 10), "building=yes height=12");
        float[] corners = {-100, -100, -10, 100, -100, 10, 100, 100, 10, -100, 100, -10};
        TriangleMesh slope = TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3});
        LoadedBuildings loaded = load(BuildingSettings.of("map.osm"), Optional.of(new TerrainGround(slope)));

        assertThat(highest(loaded.mesh())).isCloseTo(3.0 + 12.0, within(1e-3));
        assertThat(volume(loaded.mesh())).isCloseTo(200 * 13, within(0.05));
    }

    /** At 45 degrees the ground climbs by the length of a house: 20 m, 25 m and 9 m, for roofs of 9 m. */
    @Test
    void roofsBelowTheHighestGroundAreNamedOnce() throws IOException {
        way(box(-40, 0, -20, 10), "building=yes height=9");
        int worst = way(box(0, 0, 25, 10), "building=yes height=9");
        way(box(40, 0, 49, 10), "building=yes height=9");
        way(box(60, 0, 69, 10), "building=yes height=12");
        float[] corners = {-100, -100, -100, 100, -100, 100, 100, 100, 100, -100, 100, -100};
        TriangleMesh slope = TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3});
        assertThat(load(BuildingSettings.of("map.osm"), Optional.of(new TerrainGround(slope)))
                        .warnings())
                .containsExactly("map.osm: buildings whose roofs lie below the highest ground under them: 2 of 4; way/"
                        + worst + " is 9.0 m high on ground that rises by 25.0 m; heights are measured from the lowest"
                        + " ground");
        assertThat(load().warnings()).isEmpty();
    }

    /** A dip between the corners of the house counts as well. */
    @Test
    void aHollowUnderTheMiddleIsFound() throws IOException {
        way(box(-20, -20, 20, 20), "building=yes height=12");
        float[] corners = {-100, -100, 0, 100, -100, 0, 100, 100, 0, -100, 100, 0, 3, 1, -7};
        TriangleMesh hollow = TriangleMesh.of(corners, new int[] {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4});
        assertThat(highest(load(BuildingSettings.of("map.osm"), Optional.of(new TerrainGround(hollow)))
                        .mesh()))
                .isCloseTo(5.0, within(1e-3));
    }

    /** Where nothing is known of the ground, nothing is built on it. */
    @Test
    void whatStandsInAHoleOfTheTerrainIsLeftOut() throws IOException {
        way(box(30, 0, 50, 10), "building=yes height=12");
        way(box(300, 0, 320, 10), "building=yes height=12");
        float[] corners = {-100, -100, 0, 100, -100, 0, 100, 100, 0, -100, 100, 0};
        TriangleMesh small = TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3});
        LoadedBuildings loaded = load(BuildingSettings.of("map.osm"), Optional.of(new TerrainGround(small)));
        assertThat(loaded.count()).isEqualTo(1);
        assertThat(loaded.description()).anyMatch(line -> line.contains("1 building without ground below"));
    }

    /**
     * A wood of 40 m x 30 m with a clearing of 10 m x 10 m, across a ridge: its top lies 15 m over the ground
     * everywhere.
     */
    @Test
    void aWoodIsACanopyThatFollowsTheGround() throws IOException {
        int outer = way(box(-20, -15, 20, 15), "");
        int inner = way(box(-5, -5, 5, 5), "");
        relation("outer=" + outer + " inner=" + inner, "type=multipolygon natural=wood");
        way(box(60, 0, 70, 10), "landuse=forest building=yes height=4");
        float[] corners = {-100, -100, -30, 3, -100, 0, 100, -100, -40, -100, 100, -30, 3, 100, 5, 100, 100, -40};
        TerrainGround ridge =
                new TerrainGround(TriangleMesh.of(corners, new int[] {0, 1, 4, 0, 4, 3, 1, 2, 5, 1, 5, 4}));
        BuildingSettings settings = BuildingSettings.of("map.osm");
        LoadedBuildings without = load(settings, Optional.of(ridge));
        assertThat(without.woods().triangleCount()).isZero();
        assertThat(without.description()).anyMatch(line -> line.contains("left out: 1 wood"));

        LoadedBuildings loaded = load(settings.withWoodHeight(15), Optional.of(ridge));
        assertThat(loaded.count()).isEqualTo(1);
        assertThat(loaded.description()).contains("woods: 1 wood, 1,100 m2, 15 m high");
        assertThat(loaded.woods().materialNames()).containsExactly("foliage_edge");
        World wood = World.of(loaded.woods());
        long seed = 5L;
        Random random = new Random(seed);
        for (int i = 0; i < 500; i++) {
            double x = -22 + 44 * random.nextDouble();
            double y = -17 + 34 * random.nextDouble();
            boolean isInside = Math.abs(x) < 20 && Math.abs(y) < 15 && !(Math.abs(x) < 5 && Math.abs(y) < 5);
            assertThat(wood.surfaceHeight(x, y).isPresent())
                    .as("seed %d: %s %s", seed, x, y)
                    .isEqualTo(isInside);
            if (isInside) {
                assertThat(wood.surfaceHeight(x, y).orElseThrow())
                        .as("seed %d: %s %s", seed, x, y)
                        .isCloseTo(ridge.heightAt(x, y) + 15.0, within(1e-3));
            }
        }
        Visibility visibility = new Visibility(wood);
        assertThat(visibility.isFree(-40, 10, 0, -21, 10, 0)).isTrue();
        assertThat(visibility.isFree(-40, 10, 0, -10, 10, 0)).isFalse();
        assertThat(visibility.isFree(0, 0, 10, 0, 12, 10)).isFalse();
        // Just above the ground and a little below it, walls reach.
        assertThat(visibility.isFree(-40, 0, ridge.heightAt(-20, 0) - 0.9, -10, 0, ridge.heightAt(-20, 0) - 0.9))
                .isFalse();
    }

    @Test
    void aMaterialOfTheMapIsItsAcousticSurface() throws IOException {
        way(box(0, 0, 20, 10), "building=yes height=5 building:material=glass");
        way(box(30, 0, 50, 10), "building=yes building:material=wood");
        assertThat(load(BuildingSettings.of("map.osm").withMaterial("limestone"), Optional.empty())
                        .mesh()
                        .materialNames())
                .containsExactly("glass_double", "wood_16mm:assumed-height");
    }

    /** Walls far from the origin stand upright on the round earth: 10 km away they lean by 1.6 mm in a metre. */
    @Test
    void farAwayWallsLeanAsTheEarthIsRound() throws IOException {
        way(box(9990, 0, 10010, 20), "building=yes height=100");
        TriangleMesh mesh = load(BuildingSettings.of("map.osm").withRadius(12_000), Optional.empty())
                .mesh();
        double low = Double.POSITIVE_INFINITY;
        double high = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < mesh.vertexCount(); i++) {
            boolean isTop = mesh.vertexCoordinate(i, 2) > 50.0;
            low = isTop ? low : Math.min(low, mesh.vertexCoordinate(i, 0));
            high = isTop ? Math.max(high, mesh.vertexCoordinate(i, 0)) : high;
        }
        assertThat(highest(mesh)).isCloseTo(100.0 - 10_000.0 * 10_000.0 / (2 * 6.389e6), within(0.05));
        assertThat(high - low - 20.0).isCloseTo(101.0 * 10_000.0 / 6.389e6, within(0.01));
    }

    @Test
    void nothingNearTheOriginIsAnError() throws IOException {
        way(box(5000, 0, 5020, 10), "building=yes height=12");
        assertThatThrownBy(this::load)
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith("map.osm: has no building within 2000 m of the origin, at latitude 50.00000 and"
                        + " longitude 15.00000: it covers latitude 49.9");
    }

    /**
     * The outlines of Monaco: those of ways alone have 597,619 m2 by an independent computation (WGS 84, earth-centred,
     * east-north-up about the mean of the map's nodes), and 17,168 m2 are those of four multipolygons, two of which
     * share a wall.
     */
    @Test
    void monacoHasItsArea() throws IOException {
        Origin origin = Origin.at(Math.toRadians(43.7369557132469), Math.toRadians(7.422733173869995));
        BuildingSettings settings = BuildingSettings.of("monaco.osm.gz").withRadius(4000);
        LoadedBuildings loaded = new BuildingLoader(Path.of("sites")).load(settings, origin, Optional.empty());

        assertThat(loaded.count()).isEqualTo(966);
        assertThat(loaded.area())
                .isCloseTo(597_619.2 + 16_840.85 - 1567.80 + 1460.49 - 118.68 + 268.08 + 285.03, within(0.1));
        assertThat(loaded.assumed()).isEqualTo(966);
        assertThat(loaded.warnings()).hasSize(1);
    }
}
