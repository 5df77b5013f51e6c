package org.dronewatch.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.dronewatch.world.WorldSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Models in coordinates of national grids, against PROJ 9.5.1 (pyproj 3.7.2). */
class NationalGridTest {
    private static final String PRAGUE_GRID = "EPSG:5514";

    /** Krovak's coordinates of latitude 50.08 and longitude 14.42 degrees. */
    private static final double PRAGUE_X = -743_011.7235;

    private static final double PRAGUE_Y = -1_043_823.1814;

    private static final Origin PRAGUE =
            Origin.at(Math.toRadians(50.08), Math.toRadians(14.42)).withHeight(250.0);

    @TempDir
    private Path directory;

    /** A model of one triangle, from a file with z up. */
    private TriangleMesh triangle(ModelSettings settings, Origin origin, double[]... corners) throws IOException {
        Files.writeString(directory.resolve(settings.file()), text(settings.file(), corners));
        return new ModelLoader(directory).load(settings, Optional.of(origin)).mesh();
    }

    private static String text(String name, double[]... corners) {
        StringBuilder text = new StringBuilder();
        String line = name.endsWith("obj")
                ? "v %.4f %.4f %.4f%n"
                : name.endsWith("ply") ? "%.4f %.4f %.4f%n" : "vertex %.4f %.4f %.4f%n";
        Stream.of(corners)
                .forEach(corner -> text.append(String.format(Locale.ROOT, line, corner[0], corner[1], corner[2])));
        if (name.endsWith("obj")) {
            return text + "f 1 2 3\n";
        }
        return name.endsWith("ply")
                ? "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
                        + "element face 1\nproperty list uchar int vertex_index\nend_header\n" + text + "3 0 1 2\n"
                : "solid\nfacet normal 0 0 1\nouter loop\n" + text + "endloop\nendfacet\nendsolid\n";
    }

    private static ModelSettings model(String file, String crs) {
        return ModelSettings.of(file).withUpAxis(UpAxis.Z).withCrs(crs);
    }

    /** Earth-centred coordinates by the textbook, m: WGS 84. */
    private static double[] earthCentred(double latitude, double longitude, double height) {
        double flattening = 1.0 / 298.257223563;
        double e2 = flattening * (2.0 - flattening);
        double phi = Math.toRadians(latitude);
        double lambda = Math.toRadians(longitude);
        double normal = 6_378_137.0 / Math.sqrt(1.0 - e2 * Math.sin(phi) * Math.sin(phi));
        return new double[] {
            (normal + height) * Math.cos(phi) * Math.cos(lambda),
            (normal + height) * Math.cos(phi) * Math.sin(lambda),
            (normal * (1.0 - e2) + height) * Math.sin(phi)
        };
    }

    /** East, north and up of one place from another, by rows of the rotation. */
    private static Position fromPlace(double[] there, double[] here, double latitude, double longitude) {
        double phi = Math.toRadians(latitude);
        double lambda = Math.toRadians(longitude);
        double x = there[0] - here[0];
        double y = there[1] - here[1];
        double z = there[2] - here[2];
        double away = Math.cos(lambda) * x + Math.sin(lambda) * y;
        return new Position(
                -Math.sin(lambda) * x + Math.cos(lambda) * y,
                -Math.sin(phi) * away + Math.cos(phi) * z,
                Math.cos(phi) * away + Math.sin(phi) * z);
    }

    /** The scene's origin lies 2 to 5 km away; a float there is a quarter of a millimetre. */
    @ParameterizedTest
    @CsvFileSource(resources = "/org/dronewatch/geo/grids.csv", numLinesToSkip = 1)
    void verticesLieWhereProjHasThem(
            String crs, double latitude, double longitude, double east, double north, double tolerance)
            throws IOException {
        double southern = latitude - 0.02;
        double western = longitude - 0.03;
        Origin origin =
                Origin.at(Math.toRadians(southern), Math.toRadians(western)).withHeight(180.0);
        Position expected = fromPlace(
                earthCentred(latitude, longitude, 212.5), earthCentred(southern, western, 180.0), southern, western);
        TriangleMesh mesh = triangle(
                model("model.obj", crs),
                origin,
                new double[] {east, north, 212.5},
                new double[] {east + 10.0, north, 212.5},
                new double[] {east, north + 10.0, 212.5});
        assertThat(mesh.triangle(0).a().distance(expected)).isLessThan(tolerance);
    }

    /** North on Krovak's grid points 7.8 degrees west of north: without the transform 684 m are missing after 5 km. */
    @ParameterizedTest
    @ValueSource(strings = {"model.obj", "model.ply", "model.stl"})
    void aGridWhoseNorthIsEightDegreesOffNeedsNoHeading(String file) throws IOException {
        double[][] corners = {
            {PRAGUE_X, PRAGUE_Y, 250.0},
            {PRAGUE_X + 4963.442, PRAGUE_Y - 680.740, 250.0},
            {PRAGUE_X + 682.381, PRAGUE_Y + 4958.200, 250.0}
        };
        TriangleMesh mesh = triangle(model(file, PRAGUE_GRID), PRAGUE, corners);
        assertThat(mesh.triangle(0).a().distance(new Position(0, 0, 0))).isLessThan(0.1);
        assertThat(mesh.triangle(0).b().distance(new Position(5010.565, 2.347, -1.964)))
                .isLessThan(0.1);
        assertThat(mesh.triangle(0).c().distance(new Position(0.0, 5005.593, -1.966)))
                .isLessThan(0.1);
    }

    /** What was subtracted from the coordinates is added again; the position is a correction on the ground. */
    @Test
    void aShiftedFileInMillimetres() throws IOException {
        double[][] metres = {
            {PRAGUE_X, PRAGUE_Y, 250.0}, {PRAGUE_X + 700.0, PRAGUE_Y, 250.0}, {PRAGUE_X, PRAGUE_Y + 90.0, 250.0}
        };
        TriangleMesh whole = triangle(model("model.obj", PRAGUE_GRID), PRAGUE, metres);
        double[][] shifted = new double[3][];
        for (int i = 0; i < 3; i++) {
            // From z up to y up, too.
            shifted[i] = new double[] {
                1000.0 * (metres[i][0] + 743_000.0), 1000.0 * metres[i][2], -1000.0 * (metres[i][1] + 1_043_000.0)
            };
        }
        ModelSettings settings = ModelSettings.of("model.obj")
                .withScale(0.001)
                .withCrs(PRAGUE_GRID)
                .withOrigin(new FilePoint(743_000_000.0, 0, -1_043_000_000.0))
                .withPosition(new Position(1, 2, 3));
        TriangleMesh moved = triangle(settings, PRAGUE, shifted);
        assertThat(moved.triangle(0).b().distance(whole.triangle(0).b().plus(new Position(1, 2, 3))))
                .isLessThan(1e-3);
    }

    /**
     * The same zone in metres and in feet of the US survey, of 1200/3937 m, in the register: Long Island. The heights
     * are in feet, too.
     */
    @Test
    void aGridInFeet() throws IOException {
        double foot = 1200.0 / 3937.0;
        Origin newYork = Origin.at(Math.toRadians(40.7), Math.toRadians(-74.0)).withHeight(0.0);
        TriangleMesh metres = triangle(
                model("model.obj", "EPSG:32118"),
                newYork,
                new double[] {300_000, 60_000, 30},
                new double[] {300_100, 60_000, 30},
                new double[] {300_000, 60_100, 30});
        TriangleMesh feet = triangle(
                model("model.obj", "EPSG:2263").withScale(foot),
                newYork,
                new double[] {300_000 / foot, 60_000 / foot, 30 / foot},
                new double[] {300_100 / foot, 60_000 / foot, 30 / foot},
                new double[] {300_000 / foot, 60_100 / foot, 30 / foot});
        assertThat(metres.triangle(0).a().distance(new Position(0, 0, 0))).isBetween(100.0, 10_000.0);
        assertThat(feet.triangle(0).a().distance(metres.triangle(0).a())).isLessThan(1e-3);
        assertThat(feet.triangle(0).b().distance(metres.triangle(0).b())).isLessThan(1e-3);
    }

    /**
     * Runs of a sweep share models, but not if the origin differs between them. The triangle is so small that the
     * curvature of the earth lowers its corners by a fiftieth of a millimetre only.
     */
    @Test
    void aWorldWithAnotherOriginDoesNotShareTheModel() throws IOException {
        Files.writeString(
                directory.resolve("model.obj"),
                text(
                        "model.obj",
                        new double[] {PRAGUE_X - 5, PRAGUE_Y - 5, 260},
                        new double[] {PRAGUE_X + 15, PRAGUE_Y - 5, 260},
                        new double[] {PRAGUE_X - 5, PRAGUE_Y + 15, 260}));
        WorldSettings world = WorldSettings.of(model("model.obj", PRAGUE_GRID));
        ModelCache cache = new ModelCache(directory, note -> {});
        assertThat(cache.ground(world.withOrigin(PRAGUE)).height(0, 0).orElseThrow())
                .isEqualTo(10.0, within(1e-3));
        assertThat(cache.ground(world.withOrigin(PRAGUE.withHeight(200.0)))
                        .height(0, 0)
                        .orElseThrow())
                .isEqualTo(60.0, within(1e-3));
    }

    @Test
    void theHeightOfTheSceneCounts() throws IOException {
        Files.writeString(
                directory.resolve("model.obj"),
                text(
                        "model.obj",
                        new double[] {PRAGUE_X, PRAGUE_Y, 250},
                        new double[] {PRAGUE_X + 10, PRAGUE_Y, 250},
                        new double[] {PRAGUE_X, PRAGUE_Y + 10, 250}));
        ModelLoader loader = new ModelLoader(directory);
        ModelSettings settings = model("model.obj", PRAGUE_GRID);
        TriangleMesh there = loader.load(settings, Optional.of(PRAGUE)).mesh();
        TriangleMesh lower =
                loader.load(settings, Optional.of(PRAGUE.withHeight(200.0))).mesh();
        assertThat(lower.triangle(0).a().z() - there.triangle(0).a().z()).isEqualTo(50.0, within(1e-3));
        assertThatThrownBy(() -> loader.load(settings))
                .isInstanceOf(InputException.class)
                .hasMessage("model.obj: crs EPSG:5514 needs a world.origin, the latitude and longitude of x = y = 0");
        assertThat(loader.load(model("model.obj", "EPSG:32633"), Optional.of(PRAGUE))
                        .warnings())
                .anyMatch(line -> line.contains("plus any shift given by its origin, are those of EPSG:32633"));
    }

    @Test
    void whatLiesOffTheGridIsNamedWithItsLine() throws IOException {
        Files.writeString(directory.resolve("model.obj"), "v 500000 5500000 0\nv 1e30 5500000 0\nv 0 1 2\nf 1 2 3\n");
        assertThatThrownBy(() -> new ModelLoader(directory).load(model("model.obj", "EPSG:32633"), Optional.of(PRAGUE)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("model.obj:2: vertex: point (")
                .hasMessageContaining("lies where EPSG:32633 has no coordinates")
                .hasMessageNotContaining("\n");
        Files.writeString(
                directory.resolve("model.stl"),
                text("model.stl", new double[] {1, 2, 3}, new double[] {1e30, 5e6, 0}, new double[] {0, 0, 0}));
        assertThatThrownBy(() -> new ModelLoader(directory).load(model("model.stl", "EPSG:32633"), Optional.of(PRAGUE)))
                .isInstanceOf(InputException.class)
                .hasMessageContaining("model.stl: vertex 1: point (");
    }

    @Test
    void settingsThatContradictEachOtherAreRefused() {
        assertThatThrownBy(() -> model("model.obj", "EPSG:4326"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(
                        "crs EPSG:4326 has coordinates in degrees: a model needs a grid in metres or feet");
        assertThatThrownBy(() -> model("model.obj", "EPSG:99999")).hasMessageContaining("'EPSG:99999' is not known");
        assertThatThrownBy(() -> model("model.obj", PRAGUE_GRID).withHeading(0.1))
                .hasMessageContaining("heading must be 0 deg if 'crs' is given");
        assertThatThrownBy(() -> DroneSettings.of(model("model.obj", PRAGUE_GRID), Hover.at(new Position(0, 0, 9))))
                .hasMessageContaining("model.crs EPSG:5514 applies to models of the site, not to that of a drone");
    }

    /** As a user writes it: one line with the place in the file, and the model in its place. */
    @Test
    void aSceneFileWithAModelInAGrid() throws IOException {
        Files.writeString(
                directory.resolve("model.obj"),
                text(
                        "model.obj",
                        new double[] {PRAGUE_X, PRAGUE_Y, 250},
                        new double[] {PRAGUE_X + 10, PRAGUE_Y, 250},
                        new double[] {PRAGUE_X, PRAGUE_Y + 10, 270}));
        String scene =
                """
                world:
                  models: [{file: model.obj, upAxis: z, crs: 'EPSG:5514'}]
                """;
        Path file = Files.writeString(directory.resolve("scene.yaml"), scene);
        assertThatThrownBy(() -> new SceneRunner(new SceneFile(file)).settings())
                .isInstanceOf(InputException.class)
                .hasMessageContaining("world.models.0.crs needs a world.origin")
                .hasMessageContaining("scene.yaml");
        Files.writeString(file, scene + "  origin: {latitude: 50.08 deg, longitude: 14.42 deg, height: 250 m}\n");
        assertThat(new SceneRunner(new SceneFile(file))
                        .settings()
                        .world()
                        .models()
                        .get(0)
                        .crs())
                .contains(PRAGUE_GRID);
    }
}
