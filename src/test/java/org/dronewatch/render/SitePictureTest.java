package org.dronewatch.render;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Hit;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.parallel.Workers;
import org.dronewatch.render.canvas.Canvas;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.render.canvas.DroneMark;
import org.dronewatch.render.canvas.KindColours;
import org.dronewatch.render.canvas.LinePainter;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Point2d;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Pictures of the {@link Yard}: what stands where in it is known, so single pixels are. */
class SitePictureTest {
    private static final int WIDTH = 400;
    private static final int HEIGHT = 300;

    /** From the south, low enough that the wall hides what is behind it. */
    private static final Orbit SOUTH = new Orbit(new Position(0, 0, 4), Math.PI, 0.15, 60, 0.6);

    private static final SiteStyle BARE = new SiteStyle(1.0, false, false, false, RayFilter.ALL);

    @TempDir
    private Path directory;

    private Stage stage;
    private SceneSettings settings;
    private SitePicture pictures;

    @BeforeEach
    void buildYard() {
        Yard yard = new Yard(directory);
        stage = yard.stage();
        settings = yard.settings();
        pictures = new SitePicture(settings, stage);
    }

    private Backdrop backdrop(Orbit orbit, Optional<Cut> cut, Fineness fineness) {
        return pictures.backdrop(orbit, WIDTH, HEIGHT, cut, fineness, () -> false);
    }

    private SiteState state(List<DroneMark> drones, RecordedRays rays) {
        return new SiteState("yard", 0.0, List.of(), drones, Optional.empty(), Optional.ofNullable(rays));
    }

    private static Point2d pixel(Position place) {
        return SOUTH.camera(WIDTH, HEIGHT).pixelOf(place.toPoint3d()).orElseThrow();
    }

    private static int rgb(BufferedImage image, Position place) {
        Point2d at = pixel(place);
        return image.getRGB((int) at.x, (int) at.y) & 0xffffff;
    }

    @ParameterizedTest
    @EnumSource(Fineness.class)
    void everyPixelShowsWhatItsRayMeets(Fineness fineness) {
        Backdrop backdrop = backdrop(SOUTH, Optional.empty(), fineness);
        CameraObject camera = backdrop.camera();
        World world = stage.world();
        for (int row = 0; row < camera.height(); row++) {
            for (int column = 0; column < camera.width(); column++) {
                Optional<Hit> hit = world.closestHit(camera.ray(column, row));
                float depth = backdrop.canvas().depth[row * camera.width() + column];
                assertThat(depth < Float.POSITIVE_INFINITY).isEqualTo(hit.isPresent());
                if (hit.isPresent()) {
                    assertThat(depth * camera.obliqueness(column, row))
                            .isCloseTo(hit.get().distance(), within(1e-3));
                }
            }
        }
    }

    @Test
    void materialsHaveTheirColours() {
        BufferedImage image =
                pictures.draw(backdrop(SOUTH, Optional.empty(), Fineness.FINE), state(List.of(), null), BARE);

        Color wall = new Color(rgb(image, new Position(0, 0, 4)));
        Color lawn = new Color(rgb(image, new Position(0, -12, 0)));
        Color sky = new Color(image.getRGB(WIDTH / 2, 20));
        assertThat(wall.getRed()).isGreaterThan(2 * wall.getGreen());
        assertThat(lawn.getGreen()).isGreaterThan(2 * lawn.getRed());
        assertThat(sky.getBlue()).isGreaterThan(200);
    }

    @Test
    void aPlaceOnThePictureIsThePlaceInTheWorld() {
        Backdrop backdrop = backdrop(SOUTH, Optional.empty(), Fineness.FINE).flat();
        Position brick = new Position(4, 0, 5);
        Point2d at = pixel(brick);

        assertThat(backdrop.placeAt((int) at.x, (int) at.y).orElseThrow().distance(brick))
                .isLessThan(0.3);
        assertThat(backdrop.placeAt(WIDTH / 2, 5)).isEmpty();
        assertThat(backdrop.placeAt(-1, 5)).isEmpty();
    }

    @Test
    void linesAreHiddenByWhatStandsBeforeThem() {
        Backdrop backdrop = backdrop(SOUTH, Optional.empty(), Fineness.PLAIN);
        LinePainter lines = new LinePainter(backdrop.camera(), null, backdrop.canvas());
        lines.line(new Position(-8, 12, 3), new Position(8, 12, 3), 2.0, 0xff00ff, 1.0);
        lines.line(new Position(-8, -5, 2), new Position(8, -5, 2), 2.0, 0x00ffff, 1.0);
        // Comes out of the wall's shadow above its edge.
        lines.line(new Position(4, 12, 1), new Position(4, 12, 25), 2.0, 0xffff00, 1.0);
        BufferedImage image = backdrop.canvas().toImage(1);

        assertThat(count(image, 0xff00ff)).isZero();
        for (int x = -7; x <= 7; x++) {
            assertThat(rgb(image, new Position(x, -5, 2))).isEqualTo(0x00ffff);
        }
        assertThat(rgb(image, new Position(4, 12, 20))).isEqualTo(0xffff00);
        assertThat(rgb(image, new Position(4, 12, 4))).isNotEqualTo(0xffff00);
    }

    private static int count(BufferedImage image, int colour) {
        int found = 0;
        for (int row = 0; row < image.getHeight(); row++) {
            for (int column = 0; column < image.getWidth(); column++) {
                found += (image.getRGB(column, row) & 0xffffff) == colour ? 1 : 0;
            }
        }
        return found;
    }

    @Test
    void linesThatBeginBehindTheEyeAreDrawnFromWhereTheyAreBeforeIt() {
        Backdrop backdrop = backdrop(SOUTH, Optional.empty(), Fineness.PLAIN);
        LinePainter lines = new LinePainter(backdrop.camera(), null, backdrop.canvas());
        Position behind = SOUTH.eye().plus(new Position(0.3, -20, -0.2));
        lines.line(behind, new Position(0, -1, 4), 2.0, 0xff00ff, 1.0);
        lines.line(behind, behind.plus(new Position(5, 0, 5)), 2.0, 0x00ffff, 1.0);
        BufferedImage image = backdrop.canvas().toImage(1);

        assertThat(rgb(image, new Position(0, -1.05, 4))).isEqualTo(0xff00ff);
        assertThat(count(image, 0x00ffff)).isZero();
    }

    @Test
    void aCutShowsWhatIsBelowItAndTheSolidItGoesThrough() {
        Orbit above = new Orbit(new Position(0, 0, 4), Math.PI, 1.2, 60, 0.6);
        Backdrop backdrop = backdrop(above, Optional.of(Cut.above(5)), Fineness.PLAIN);
        for (int row = 0; row < HEIGHT; row += 3) {
            for (int column = 0; column < WIDTH; column += 3) {
                backdrop.placeAt(column, row)
                        .ifPresent(place -> assertThat(place.z()).isLessThan(5.0 + 1e-3));
            }
        }
        Point2d inWall = above.camera(WIDTH, HEIGHT)
                .pixelOf(new Position(0, 0.5, 5).toPoint3d())
                .orElseThrow();
        Position section = backdrop.placeAt((int) inWall.x, (int) inWall.y).orElseThrow();
        assertThat(section.z()).isCloseTo(5.0, within(1e-3));
        int shown = backdrop.canvas().rgb[(int) inWall.y * WIDTH + (int) inWall.x];
        Color colour = new Color(shown);
        assertThat(Math.abs(colour.getRed() - colour.getGreen()))
                .as("a grey section")
                .isLessThan(20);
    }

    @Test
    void aCutThatTakesNothingChangesNothing() {
        Canvas whole = backdrop(SOUTH, Optional.empty(), Fineness.PLAIN).canvas();
        Canvas cut =
                backdrop(SOUTH, Optional.of(Cut.above(1000)), Fineness.PLAIN).canvas();

        int different = 0;
        for (int i = 0; i < whole.rgb.length; i++) {
            different += whole.rgb[i] == cut.rgb[i] ? 0 : 1;
        }
        // Only edges that a ray meets within rounding may fall to either side.
        assertThat(different).isLessThan(whole.rgb.length / 1000);
    }

    @Test
    void theDroneIsPaintedExactlyWhereItIs() {
        Orbit near = SOUTH.at(new Position(0, -10, 3)).showing(1.5);
        Drone drone = stage.dronesAt(100.0).get(0);
        CameraObject camera = near.camera(WIDTH, HEIGHT);
        Canvas canvas = pictures.backdrop(near, WIDTH, HEIGHT, Optional.empty(), Fineness.PLAIN, () -> false)
                .canvas();
        Canvas before = canvas.copy();
        new DronePainter(drone, 0xe8501e).paint(camera, canvas);
        int hits = 0;
        for (int row = 0; row < HEIGHT; row++) {
            for (int column = 0; column < WIDTH; column++) {
                int pixel = row * WIDTH + column;
                boolean painted = canvas.depth[pixel] != before.depth[pixel];
                assertThat(painted).as("column %d, row %d", column, row).isEqualTo(meets(drone, camera, column, row));
                assertThat(canvas.rgb[pixel] != before.rgb[pixel]).isEqualTo(painted);
                hits += painted ? 1 : 0;
            }
        }
        assertThat(hits).isGreaterThan(2000);
    }

    @Test
    void aDroneBehindTheWallIsNotPainted() {
        Drone drone = stage.dronesAt(100.0).get(0).move(new Vector3d(0, 15, 0));
        Backdrop backdrop = backdrop(SOUTH, Optional.empty(), Fineness.PLAIN);
        Canvas canvas = backdrop.canvas().copy();
        new DronePainter(drone, 0xe8501e).paint(backdrop.camera(), canvas);

        assertThat(canvas.rgb).isEqualTo(backdrop.canvas().rgb);
    }

    private static boolean meets(Drone drone, CameraObject camera, int column, int row) {
        RayTracer traversal = new StackTraversal(drone.tree());
        var origin = camera.position().toPoint3d();
        drone.worldToModel().transform(origin);
        var direction = camera.ray(column, row).direction();
        drone.worldToModel().transform(direction);
        return traversal.closestHit(
                origin.x, origin.y, origin.z, direction.x, direction.y, direction.z, 0.0, Double.POSITIVE_INFINITY);
    }

    @Test
    void aRayOfSoundCrossesWhereItMustInTheColourOfTheLegend() {
        RayCollector collector = new RayCollector("microphone", "quadrotor", 8.0);
        Position from = new Position(-8, -6, 1);
        Position to = new Position(8, -6, 6);
        collector.record(from.x(), from.y(), from.z(), to.x(), to.y(), to.z(), 42.0, 0, true);
        collector.record(-8, -6, 6, 8, -6, 1, 31.0, 1, false);
        RecordedRays rays = collector.toRays();
        LevelScale levels = rays.scale();
        BufferedImage image =
                pictures.draw(backdrop(SOUTH, Optional.empty(), Fineness.FINE).flat(), state(List.of(), rays), BARE);

        Position onFirst = from.plus(to.minus(from).times(0.25));
        assertNear(new Color(rgb(image, onFirst)), new Color(levels.colour(42.0)), 40);
        assertThat(levels.low()).isEqualTo(30.0);
        assertThat(levels.high()).isEqualTo(45.0);
        // The legend's bar holds the very colours of its levels.
        for (double level = 30.5; level < 45.0; level += 0.5) {
            assertThat(count(image, levels.colour(level))
                            + count(image, levels.colour(level + 15.0 / 360))
                            + count(image, levels.colour(level - 15.0 / 360)))
                    .as("pixels in the colour of %s dB", level)
                    .isPositive();
        }
        RayFilter direct = new RayFilter(0, 0, false);
        BufferedImage filtered = pictures.draw(
                backdrop(SOUTH, Optional.empty(), Fineness.FINE).flat(),
                state(List.of(), rays),
                BARE.withFilter(direct));
        Position onSecond = new Position(-4, -6, 4.75);
        assertThat(rgb(filtered, onSecond)).isNotEqualTo(rgb(image, onSecond));
        assertThat(rgb(filtered, onFirst)).isEqualTo(rgb(image, onFirst));
    }

    private static void assertNear(Color actual, Color expected, int tolerance) {
        assertThat(Math.abs(actual.getRed() - expected.getRed()))
                .as("red of " + actual + ", " + expected)
                .isLessThan(tolerance);
        assertThat(Math.abs(actual.getGreen() - expected.getGreen()))
                .as("green of " + actual + ", " + expected)
                .isLessThan(tolerance);
        assertThat(Math.abs(actual.getBlue() - expected.getBlue()))
                .as("blue of " + actual + ", " + expected)
                .isLessThan(tolerance);
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 45, 90, 135, 180, 225, 270, 315})
    void theNorthArrowPointsWhereNorthLiesInThePicture(int bearing) {
        Orbit orbit = new Orbit(new Position(0, 0, 0), Math.toRadians(bearing), 0.8, 60, 0.6);
        BufferedImage image = pictures.draw(
                pictures.backdrop(orbit, WIDTH, HEIGHT, Optional.empty(), Fineness.PLAIN, () -> false),
                state(List.of(), null),
                BARE);
        CameraObject camera = orbit.camera(WIDTH, HEIGHT);
        Point2d north = camera.pixelOf(new Position(0, 5, 0).toPoint3d()).orElseThrow();
        north.sub(camera.pixelOf(new Position(0, 0, 0).toPoint3d()).orElseThrow());

        // The letter N and the arrow's point lie on one side of the middle of the paper, the tail's notch on the other.
        double cx = WIDTH - 12 - 29;
        double cy = 12 + 29;
        double along = 0.0;
        for (int row = 13; row < 69; row++) {
            for (int column = WIDTH - 69; column < WIDTH - 13; column++) {
                Color colour = new Color(image.getRGB(column, row));
                if (colour.getRed() < 110) {
                    double dx = column + 0.5 - cx;
                    double dy = row + 0.5 - cy;
                    // Far out only the letter is dark.
                    along += Math.hypot(dx, dy) > 15 ? Math.signum(dx * north.x + dy * north.y) : 0.0;
                }
            }
        }
        assertThat(along).isPositive();
    }

    @Test
    void aCamerasOutlineEndsInTheCornersOfItsPicture() {
        CameraSettings camera = (CameraSettings) settings.sensors().get("camera");
        Outline.Frustum outline = (Outline.Frustum) camera.outline();
        CameraObject object = new CameraObject(camera);
        Position corner = camera.position()
                .plus(outline.forward()
                        .plus(outline.right().times(outline.halfWidth()))
                        .plus(outline.up().times(-outline.halfHeight()))
                        .times(7));

        Point2d at = object.pixelOf(corner.toPoint3d()).orElseThrow();

        assertThat(at.x).isCloseTo(camera.width(), within(1e-6));
        assertThat(at.y).isCloseTo(camera.height(), within(1e-6));
    }

    /** Two sensors alone do not say how much of the site is worth seeing. */
    @Test
    void withoutAFlightTheWholeSiteIsFramed() {
        AABB site = stage.world().bounds();
        assertThat(pictures.interest().minX()).isGreaterThan(site.minX());

        SceneSettings still = SettingsForm.with(settings, "drones", Map.of());
        AABB whole = new SitePicture(still, new Stage(still, new ModelCache(directory, line -> {}), 0L)).frame();
        assertThat(whole.union(site)).isEqualTo(whole);
    }

    @Test
    void picturesAreTheSameForAnyNumberOfThreads() {
        Orbit orbit = Orbit.about(pictures.interest(), 4.0 / 3.0);
        SiteState state = pictures.state(
                "yard", 2.0, (sensor, drone) -> true, sensor -> Optional.empty(), Optional.empty(), Optional.empty());
        int[][] images = new int[3][];
        for (int threads = 1; threads <= 3; threads++) {
            try (Workers workers = new Workers(threads)) {
                BufferedImage image = workers.call(() -> pictures.draw(
                        pictures.backdrop(orbit, WIDTH, HEIGHT, Optional.empty(), Fineness.FINE, () -> false),
                        state,
                        SiteStyle.DEFAULT));
                images[threads - 1] = image.getRGB(0, 0, WIDTH, HEIGHT, null, 0, WIDTH);
            }
        }
        assertThat(images[1]).isEqualTo(images[0]);
        assertThat(images[2]).isEqualTo(images[0]);
    }

    @Test
    void onlyASceneUnderARoofIsCutOpen() {
        assertThat(pictures.openRoof(0)).isEmpty();
    }

    @Test
    void linesOfAnyDirectionAreAsWideAsAsked() {
        long seed = 20261121;
        Random random = new Random(seed);
        for (int i = 0; i < 200; i++) {
            Canvas canvas = new Canvas(200, 200);
            Orbit orbit = new Orbit(new Position(0, 0, 0), 0.0, 0.0, 10, 0.6);
            double angle = 2 * Math.PI * random.nextDouble();
            double width = 1.0 + 3.0 * random.nextDouble();
            Position end = new Position(2 * Math.cos(angle), 0, 2 * Math.sin(angle));
            new LinePainter(orbit.camera(200, 200), null, canvas).line(end.times(-1), end, width, 0xffffff, 1.0);
            double ink = 0.0;
            for (int colour : canvas.rgb) {
                ink += (colour & 255) / 255.0;
            }
            Point2d a = orbit.camera(200, 200).pixelOf(end.toPoint3d()).orElseThrow();
            double length = 2 * Math.hypot(a.x - 100, a.y - 100);
            assertThat(ink)
                    .as("seed %d, line %d", seed, i)
                    .isCloseTo(length * width, within(0.06 * length * width + 6));
        }
    }

    @Test
    void aKindHasItsColourInEveryScene() {
        KindColours both = KindColours.of(settings.sensors().values());
        KindColours one = KindColours.of(List.of(settings.sensors().get("microphone")));

        assertThat(one.of("acoustic")).isEqualTo(both.of("acoustic")).isNotEqualTo(both.of("camera"));
        assertThat(one.kinds()).containsExactly("acoustic");
    }
}
