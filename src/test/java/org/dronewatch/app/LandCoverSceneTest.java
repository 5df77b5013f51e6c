package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.imageio.ImageIO;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.buildings.DrawnMap;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.render.photo.ColourCamera;
import org.dronewatch.run.Stage;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A meadow with a lake in its eastern half, a road and a house on it, as a user writes and draws it. */
class LandCoverSceneTest {
    private static final Origin ORIGIN =
            Origin.at(Math.toRadians(50.0), Math.toRadians(15.0)).withHeight(200.0);

    private static final String SITE =
            """
            world:
              origin: {latitude: 50.0 deg, longitude: 15.0 deg, height: 200 m}
              terrain: {file: ground.asc, crs: EPSG:32633, accuracy: 0}
              buildings: {file: map.osm, radius: 100 m, landCover: true}
            """;

    @TempDir
    private static Path directory;

    private static Path scene;
    private static Stage covered;
    private static Stage plain;

    @BeforeAll
    static void readSite() throws IOException {
        Files.writeString(
                directory.resolve("ground.asc"),
                "ncols 41\nnrows 41\nxllcenter 499900\nyllcenter 5538530.74\ncellsize 5\n" + "200 ".repeat(41 * 41));
        DrawnMap map = new DrawnMap(ORIGIN);
        map.area(new double[] {0, -150, 150, -150, 150, 150, 0, 150}, "natural=water");
        map.line(new double[] {-150, 40, -10, 40}, "highway=primary");
        map.area(new double[] {20, -10, 30, -10, 30, 10, 20, 10}, "building=yes height=5");
        Files.writeString(directory.resolve("map.osm"), map.osm());
        scene = Files.writeString(directory.resolve("site.yaml"), SITE);
        covered = stage(scene);
        plain = stage(Files.writeString(directory.resolve("plain.yaml"), SITE.replace(", landCover: true", "")));
    }

    private static Stage stage(Path file) {
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        return runner.stage(runner.settings());
    }

    /** The ground under a point, whose triangle is that of the terrain. */
    private static String material(World world, double x, double y) {
        RayTracer tracer = world.newRayTracer();
        assertThat(tracer.closestHit(x, y, 50, 0, 0, -1, 0.0, 100.0)).isTrue();
        return world.materialNames().get(world.material(tracer.triangle(), x, y));
    }

    @Test
    void theMaterialIsThatAtThePoint() {
        World world = covered.world();
        assertThat(material(world, -50, 0)).isEqualTo("pasture_uncompacted");
        assertThat(material(world, -50, 37)).isEqualTo("asphalt:road");
        assertThat(material(world, -50, 45)).isEqualTo("pasture_uncompacted");
        assertThat(material(world, 50, 0)).isEqualTo("water_surface:water");
        assertThat(material(world, 25, 0)).isEqualTo("brick_rendered");
        assertThat(world.materialNames())
                .containsExactly("pasture_uncompacted", "brick_rendered", "water_surface:water", "asphalt:road");
        assertThat(world.surfaces())
                .extracting(surface -> surface.name())
                .containsExactly("pasture_uncompacted", "brick_rendered", "water_surface", "asphalt");

        World without = plain.world();
        assertThat(material(without, 50, 0)).isEqualTo("pasture_uncompacted");
        assertThat(without.materialNames()).isEqualTo(without.mesh().materialNames());
        assertThat(without.surfaces()).hasSize(2);
        assertThat(without.mesh().triangleCount()).isEqualTo(world.mesh().triangleCount());
    }

    /** The line meets the ground 10 m before its end, on the road; the triangle there is the terrain's. */
    @Test
    void anObstacleIsNamedByWhatIsThere() {
        Position sensor = new Position(-50, -3, 20);
        Position drone = new Position(-50, 57, -10);
        assertThat(new Visibility(covered.world()).obstacle(sensor, drone))
                .hasValueSatisfying(obstacle -> assertThat(obstacle.material()).isEqualTo("asphalt:road"));
        assertThat(new Visibility(plain.world()).obstacle(sensor, drone))
                .hasValueSatisfying(obstacle -> assertThat(obstacle.material()).isEqualTo("pasture_uncompacted"));
        assertThat(new Visibility(covered.world()).obstacle(new Position(15, 0, 2), new Position(40, 0, 2)))
                .hasValueSatisfying(obstacle -> assertThat(obstacle.material()).isEqualTo("brick_rendered"));
    }

    /** Other conditions are still about the same ground. */
    @Test
    void theGroundStaysCoveredInRain() {
        World world = covered.world().withRain(3.0).withNoiseSources(Map.of());
        assertThat(material(world, 50, 0)).isEqualTo("water_surface:water");
        assertThat(world.surfaces()).hasSize(4);
    }

    @Test
    void photographsShowIt() {
        CameraObject camera = new CameraObject(new Position(0, 0, 60), new Position(0, 0, -1), 80, 80, 80.0);
        BufferedImage with = new ColourCamera(camera, covered, 1).picture(List.of());
        BufferedImage without = new ColourCamera(camera, plain, 1).picture(List.of());
        assertThat(share(with, 0.0)).isBetween(0.40, 0.52);
        assertThat(share(without, 0.0)).isZero();
    }

    @Test
    void picturesOfTheSiteShowIt() throws IOException {
        assertThat(share(topView(scene), 20.0)).isGreaterThan(0.2);
        assertThat(share(topView(directory.resolve("plain.yaml")), 20.0)).isLessThan(0.02);
    }

    private static BufferedImage topView(Path file) throws IOException {
        Path picture = directory.resolve("top.png");
        Outcome outcome = Program.run(
                "render", file.toString(), "--view", "top", "--size", "320x240", "--out", picture.toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
        return ImageIO.read(picture.toFile());
    }

    /** The fraction of the pixels that are bluer than they are red. */
    private static double share(BufferedImage image, double by) {
        int blue = 0;
        for (int row = 0; row < image.getHeight(); row++) {
            for (int column = 0; column < image.getWidth(); column++) {
                int rgb = image.getRGB(column, row);
                blue += (rgb & 255) - (rgb >> 16 & 255) > by ? 1 : 0;
            }
        }
        return blue / (double) (image.getWidth() * image.getHeight());
    }

    @Test
    void checkAndHeightStateIt() {
        Outcome checked = Program.run("check", scene.toString());
        assertThat(checked.code()).as(checked.err()).isZero();
        assertThat(checked.err())
                .contains("land cover: 202 x 202 cells of 1 m: water 20,402 m2, road ")
                .contains("; not stated for 48 %");
        Outcome height = Program.run("height", scene.toString(), "--at", "50,15.0007");
        assertThat(height.out() + height.err()).contains("terrain of ground.asc, water_surface:water");
    }

    @Test
    void withoutTerrainThereIsNothingToCover() throws IOException {
        Path bare = Files.writeString(directory.resolve("bare.yaml"), SITE.replaceFirst(" *terrain: .*\\R", ""));
        Outcome outcome = Program.run("check", bare.toString());
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err())
                .contains("world.buildings.landCover is true, but there is no world.terrain that it could cover");
    }
}
