package org.dronewatch.render.photo;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.sensor.optics.Projection;
import org.dronewatch.world.Light;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Colours against closed forms. Levels of light are relative to that of level ground. */
class ColourCameraTest {
    /** Of the mesh's only material: its reflectance is ((0.8 + 0.055) / 1.055)^2.4 (IEC 61966-2-1). */
    private static final Map<String, Integer> GREY = Map.of("default", 0xcccccc);

    private static final double REFLECTANCE = Math.pow((0.8 + 0.055) / 1.055, 2.4);
    /**
     * What nine spherical harmonics may leave out of the light of the sky, most where it is concentrated at the
     * horizon.
     */
    private static final double HARMONICS = 0.05;

    private static final Map<String, Integer> BLACK = Map.of("default", 0);

    private static TriangleMesh rectangle(Position... corners) {
        float[] vertices = new float[3 * corners.length];
        for (int i = 0; i < corners.length; i++) {
            vertices[3 * i] = (float) corners[i].x();
            vertices[3 * i + 1] = (float) corners[i].y();
            vertices[3 * i + 2] = (float) corners[i].z();
        }
        return TriangleMesh.of(vertices, new int[] {0, 1, 2, 0, 2, 3});
    }

    private static TriangleMesh level(double half, double y, double z) {
        return rectangle(
                new Position(-half, y - half, z),
                new Position(half, y - half, z),
                new Position(half, y + half, z),
                new Position(-half, y + half, z));
    }

    private static Light sunny(double azimuth, double elevation) {
        // Air so clear that nothing of it is seen at the distances here.
        return Light.DAY.withVisibility(1e6).withSun(new Light.Sun(Math.toRadians(azimuth), Math.toRadians(elevation)));
    }

    private static World world(Light light, TriangleMesh... meshes) {
        return World.of(World.merge(List.of(meshes))).withLight(light);
    }

    private static ColourCamera above(World world, Map<String, Integer> colours, int samples) {
        return new ColourCamera(
                new CameraObject(new Position(0, 0, 40), new Position(0, 0, -1), 41, 41, 41.0),
                world,
                colours,
                Map.of(),
                samples);
    }

    private static double brightness(double[] rgb) {
        return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
    }

    /** By definition level ground in the open has all the light, whatever part of it is the sun's. */
    @ParameterizedTest
    @ValueSource(doubles = {2, 10, 30, 60, 85})
    void levelGroundReflectsAllTheLight(double elevation) {
        World world = world(sunny(200, elevation), level(500, 0, 0));
        assertThat(brightness(above(world, GREY, 1).radiance(20, 20, List.of())))
                .isCloseTo(REFLECTANCE, within(HARMONICS * REFLECTANCE));
    }

    /**
     * In haze the plate, which is nearer, is not as bright as the ground: but before the near plane the ground shows.
     */
    @Test
    void nothingIsPhotographedOutsideThePlanes() {
        Light haze = Light.DAY.withVisibility(100);
        // What lies hidden far below puts the country around there, where the haze takes its colour.
        World bare = world(haze, level(500, 0, 0), level(1, 0, -500));
        World plated = world(haze, level(500, 0, 0), level(1, 0, -500), level(3, 0, 30));
        double[] ground = planed(bare, 0, 1e6).radiance(20, 20, List.of());
        double[] plate = planed(plated, 0, 1e6).radiance(20, 20, List.of());
        assertThat(Math.abs(brightness(plate) - brightness(ground))).isGreaterThan(0.05 * brightness(ground));
        assertThat(planed(plated, 0, 20).radiance(20, 20, List.of())).isEqualTo(plate);
        double behind = brightness(planed(plated, 20, 1e6).radiance(20, 20, List.of()));
        assertThat(behind).isCloseTo(brightness(ground), within(0.01 * behind));
        double[] nothing = planed(bare, 0, 20).radiance(20, 20, List.of());
        assertThat(planed(plated, 0, 5).radiance(20, 20, List.of())).isEqualTo(nothing);
        assertThat(nothing).isNotEqualTo(ground);
    }

    private static ColourCamera planed(World world, double near, double far) {
        Projection projection = new Projection(0, 0, near, far);
        CameraObject camera =
                new CameraObject(new Position(0, 0, 40), new Position(0, 0, -1), 0, 41, 41, 41.0, projection);
        return new ColourCamera(camera, world, GREY, Map.of(), 1);
    }

    @Test
    void levelGroundReflectsAllTheLightOfACloudySky() {
        World world = world(Light.DAY.withVisibility(1e6), level(500, 0, 0));
        assertThat(brightness(above(world, GREY, 1).radiance(20, 20, List.of())))
                .isCloseTo(REFLECTANCE, within(HARMONICS * REFLECTANCE));
    }

    /**
     * What a far plate takes away from a plane is the sun's part: reflectance times the sun's light on a surface that
     * faces it times the cosine of the angle between the plane's normal and the sun (Lambert). Of the light on level
     * ground, 127.5 exp(-0.21 m) sin h is the sun's and 0.8 + 15.5 sqrt(sin h) the sky's (IESNA), m after Kasten and
     * Young.
     */
    @ParameterizedTest
    @CsvSource({"30, 0", "30, 25", "55, 35", "12, 70", "40, -30"})
    void theSunsLightFollowsTheCosineLaw(double elevation, double slope) {
        double h = Math.toRadians(elevation);
        double t = Math.toRadians(slope);
        // Tilted towards the south by the slope; the sun is in the south.
        TriangleMesh plane = rectangle(
                new Position(-5, -5 * Math.cos(t), -5 * Math.sin(t)),
                new Position(5, -5 * Math.cos(t), -5 * Math.sin(t)),
                new Position(5, 5 * Math.cos(t), 5 * Math.sin(t)),
                new Position(-5, 5 * Math.cos(t), 5 * Math.sin(t)));
        // 300 m towards the sun, so that it hides the sun and next to nothing of the sky.
        double far = 300.0;
        TriangleMesh plate = rectangle(
                new Position(-6, -far * Math.cos(h), far * Math.sin(h) - 6),
                new Position(6, -far * Math.cos(h), far * Math.sin(h) - 6),
                new Position(6, -far * Math.cos(h), far * Math.sin(h) + 6),
                new Position(-6, -far * Math.cos(h), far * Math.sin(h) + 6));
        double lit =
                brightness(above(world(sunny(180, elevation), plane), GREY, 1).radiance(20, 20, List.of()));
        double dark = brightness(
                above(world(sunny(180, elevation), plane, plate), GREY, 1).radiance(20, 20, List.of()));

        double mass = 1.0 / (Math.sin(h) + 0.50572 * Math.pow(elevation + 6.07995, -1.6364));
        double sun = 127.5 * Math.exp(-0.21 * mass);
        double sky = 0.8 + 15.5 * Math.sqrt(Math.sin(h));
        double onPlane = sun / (sun * Math.sin(h) + sky) * Math.sin(h + t);
        // What is left of the contrast over 40 m in air of 1000 km visibility.
        double air = Math.pow(0.05, 40.0 / 1e6);
        // The corners of meshes are of single precision.
        assertThat(lit - dark).isCloseTo(REFLECTANCE * onPlane * air, within(1e-6));
    }

    /** A plate 10 m above the ground; the sun stands in the south at 45 degrees: its shadow lies 10 m north of it. */
    @Test
    void aShadowLiesWhereTheSunPutsIt() {
        World bare = world(sunny(180, 45), level(100, 0, 0));
        World shaded = world(sunny(180, 45), level(100, 0, 0), level(2, -10, 10));
        ColourCamera without = above(bare, GREY, 1);
        ColourCamera with = above(shaded, GREY, 1);
        double sun = 0.0;
        int dark = 0;
        for (int row = 0; row < 41; row++) {
            for (int column = 0; column < 41; column++) {
                // On the ground: a pixel is 40/41 m wide.
                double x = (column - 20) * 40.0 / 41.0;
                double y = (20 - row) * 40.0 / 41.0;
                double lost = brightness(without.radiance(column, row, List.of()))
                        - brightness(with.radiance(column, row, List.of()));
                if (Math.abs(x) < 2 && Math.abs(y) < 2) {
                    sun = sun == 0.0 ? lost : sun;
                    // But for what the plate takes of the sky.
                    assertThat(lost).as("in the shadow, %s %s", x, y).isCloseTo(sun, within(0.02));
                    dark++;
                } else if (y > -6) {
                    // The plate itself is seen farther south.
                    assertThat(lost).as("in the sun, %s %s", x, y).isBetween(-1e-9, 0.05);
                }
            }
        }
        assertThat(dark).isEqualTo(25);
        assertThat(sun).isGreaterThan(0.3);
    }

    /** A black wall at a range r against the horizon: it has 1 - exp(-3.912 r / V) of the sky's radiance. */
    @ParameterizedTest
    @CsvSource({"100, 1000", "800, 1000", "800, 20000", "2500, 5000"})
    void aBlackWallFadesByKoschmiedersLaw(double range, double visibility) {
        Light light = Light.DAY.withContrastAtVisibility(0.02).withVisibility(visibility);
        TriangleMesh wall = rectangle(
                new Position(-10, range, -10),
                new Position(10, range, -10),
                new Position(10, range, 10),
                new Position(-10, range, 10));
        CameraObject camera =
                new CameraObject(new Position(0, 0, 0), new Position(0, 1, 0), 41, 41, 41.0 * range / 40.0);
        ColourCamera looking = new ColourCamera(camera, world(light, wall), BLACK, Map.of(), 1);
        double wallSeen = brightness(looking.radiance(20, 20, List.of()));
        double horizon = brightness(looking.radiance(0, 20, List.of()));
        assertThat(wallSeen / horizon).isCloseTo(1.0 - Math.exp(-Math.log(50.0) * range / visibility), within(1e-6));
        assertThat(Math.log(50.0)).isCloseTo(3.912, within(1e-4));
    }

    /** Of the sky at one elevation, that under the sun is brightest, and a low sun is redder than a high one. */
    @Test
    void theSkyIsBrighterTowardsTheSunAndReddensAtDusk() {
        double[] towards = sky(sunny(90, 10), 90);
        double[] aside = sky(sunny(90, 10), 180);
        assertThat(brightness(towards)).isGreaterThan(2.0 * brightness(aside));
        double[] noon = sky(sunny(90, 60), 90);
        double[] dusk = sky(sunny(90, 2), 90);
        assertThat(dusk[0] / dusk[2]).isGreaterThan(2.0 * noon[0] / noon[2]);
    }

    private static double[] sky(Light light, double azimuth) {
        double a = Math.toRadians(azimuth);
        CameraObject camera =
                new CameraObject(new Position(0, 0, 10), new Position(Math.sin(a), Math.cos(a), 0.02), 11, 11, 100.0);
        return new ColourCamera(camera, world(light, level(5, 0, 0)), GREY, Map.of(), 1).radiance(5, 5, List.of());
    }

    private static Drone quadrotor(Position at) {
        return DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), new Hover(at, 0.0))
                .create("quadrotor", Path.of("."));
    }

    private static ColourCamera upwards(int samples) {
        CameraObject camera = new CameraObject(new Position(0, 0, 2), new Position(0.1, 1, 0.5), 200, 150, 300.0);
        Map<String, Integer> black = Map.of("shell", 0, "dark_plastic", 0, "metal", 0, "lens", 0);
        return new ColourCamera(
                camera, world(sunny(10, 40), level(50, 0, 0)), GREY, Map.of("quadrotor", black), samples);
    }

    /** With one sample, what differs from the picture without the drone is what the sensor counts. */
    @Test
    void aDroneCoversThePixelsThatTheSensorCounts() {
        Drone drone = quadrotor(new Position(0.3, 6, 5.2));
        ColourCamera camera = upwards(1);
        BufferedImage without = camera.picture(List.of());
        BufferedImage with = camera.picture(List.of(drone));
        DronePixels hits = new DronePicture(camera.camera())
                .pixels(world(sunny(10, 40), level(50, 0, 0)), List.of(drone))
                .get(0);
        assertThat(hits.count()).isGreaterThan(100);
        for (int row = 0; row < 150; row++) {
            for (int column = 0; column < 200; column++) {
                assertThat(with.getRGB(column, row) != without.getRGB(column, row))
                        .as("pixel %d %d", column, row)
                        .isEqualTo(hits.isHit(column, row));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void thePictureIsTheSameForAnyNumberOfThreadsAndPicturesBefore(int samples) {
        List<Drone> drones = List.of(quadrotor(new Position(0.3, 6, 5.2)), quadrotor(new Position(0.5, 7, 5.4)));
        BufferedImage alone = upwards(samples).picture(drones);
        try (Workers workers = new Workers(4)) {
            BufferedImage shared = workers.call(() -> {
                ColourCamera camera = upwards(samples);
                camera.picture(List.of(quadrotor(new Position(0, 5, 5))));
                return camera.picture(drones);
            });
            assertThat(pixels(shared)).isEqualTo(pixels(alone));
        }
    }

    private static int[] pixels(BufferedImage image) {
        return image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth());
    }

    @Test
    void theNumberOfSamplesHasLimits() {
        assertThatThrownBy(() -> upwards(0)).hasMessage("samples 0 must be 1 to 8");
        assertThatThrownBy(() -> upwards(9)).hasMessage("samples 9 must be 1 to 8");
        assertThat(Optional.of(upwards(8))).isPresent();
    }
}
