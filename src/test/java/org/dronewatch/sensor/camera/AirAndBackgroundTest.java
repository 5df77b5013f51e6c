package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.SplittableRandom;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.optics.Lens;
import org.dronewatch.world.Light;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Sky or ground behind a drone, turbulent air, and a lens that diffracts. */
class AirAndBackgroundTest {
    private static final double SKY = Double.POSITIVE_INFINITY;
    private static final Light TEN_KILOMETRES = Light.DAY.withVisibility(10_000);
    private static final Lens GREEN = Lens.perfect(550e-9);

    private static DroneView view(double range, Light light, Lens lens, double background) {
        double focalLength = 960.0 / Math.tan(Math.toRadians(1.1));
        return new DroneView(400, range, focalLength, 0.0, light, SKY, lens, background);
    }

    /**
     * Duntley (1948): {@code 1 / (1 + K (exp(s R) - 1))}. Contrast 0.05 at a visibility of 10 km is s = ln 20 / 10 km =
     * 0.29957 per km; at 2 km exp(s R) = 20^0.2 = 1.82056, so that by hand K = 1 gives 1 / 1.82056 = 0.549 and K = 5
     * gives 1 / 5.1028 = 0.196.
     */
    @ParameterizedTest
    @CsvSource({"1, 0.549", "5, 0.196", "1.4, 0.465", "25, 0.0465", "0.2, 0.859"})
    void theAirTakesMoreContrastFromDarkGround(double skyToGround, double left) {
        assertThat(TEN_KILOMETRES.contrastLeft(2000, 1.0 / skyToGround)).isCloseTo(left, within(5.1e-4));
    }

    /** Step by step, the air takes a part of the light and puts as much of the sky's in its place. */
    private static double throughAir(double brightness, double distance, Light light) {
        double perMetre = -Math.log(light.contrastAtVisibility()) / light.visibility();
        int steps = 200_000;
        double now = brightness;
        for (int i = 0; i < steps; i++) {
            double half = now + 0.5 * distance / steps * perMetre * (1.0 - now);
            now += distance / steps * perMetre * (1.0 - half);
        }
        return now;
    }

    @ParameterizedTest
    @CsvSource({"5, 2000, 0", "5, 1000, 700", "2, 3000, 4000", "0.3, 1500, 100", "1, 800, 50"})
    void contrastAgainstTheGroundIsThatOfLightThroughTheAir(double skyToGround, double range, double behind) {
        Light light = TEN_KILOMETRES.withSkyToGroundRatio(skyToGround);
        double contrast = 0.3;
        double drone = throughAir(1.0 - contrast, range, light);
        double ground = throughAir(1.0 / skyToGround, behind + range, light);
        double seen = Math.abs(drone - ground) / ground;

        double resolved = TargetTask.DEFAULT.withContrast(contrast).resolved(view(range, light, GREEN, behind));
        assertThat(resolved).isCloseTo(10.0 * (1.0 - 0.02 / seen), within(1e-6));
    }

    @Test
    void groundFarBehindADroneIsAsBrightAsTheSky() {
        Light light = TEN_KILOMETRES.withSkyToGroundRatio(25.0);
        double before = TargetTask.DEFAULT.resolved(view(900, light, GREEN, SKY));

        assertThat(TargetTask.DEFAULT.resolved(view(900, light, GREEN, 1e6))).isCloseTo(before, within(1e-9));
        assertThat(light.backgroundBrightness(SKY)).isEqualTo(1.0);
        assertThat(light.backgroundBrightness(0.0)).isCloseTo(0.04, within(1e-15));
    }

    /** A drone half as bright as the sky, before ground that is half as bright as the sky. */
    @Test
    void aDroneAsBrightAsTheGroundVanishes() {
        Light light = Light.DAY.withSkyToGroundRatio(2.0);

        assertThat(TargetTask.DEFAULT.resolved(view(300, light, GREEN, 0.0))).isZero();
        assertThat(TargetTask.DEFAULT.resolved(view(300, light, GREEN, SKY))).isGreaterThan(9.0);
        assertThat(TargetTask.DEFAULT.withGroundContrast(0.3).resolved(view(300, light, GREEN, 0.0)))
                .isCloseTo(10.0 * (1.0 - 0.02 / (0.3 * light.contrastLeft(300, 0.5))), within(1e-12));
        assertThat(TargetTask.DEFAULT.withGroundContrast(0.3).resolved(view(300, light, GREEN, SKY)))
                .as("against the sky, the contrast is not that against the ground")
                .isEqualTo(TargetTask.DEFAULT.resolved(view(300, light, GREEN, SKY)));
    }

    /** Where nobody states turbulence, an aperture or the ground's brightness, all is as it was, bit for bit. */
    @Test
    void whatIsNotStatedChangesNothing() {
        SplittableRandom random = new SplittableRandom(25);
        for (int i = 0; i < 2000; i++) {
            Light light = Light.DAY
                    .withVisibility(100 + 30_000 * random.nextDouble())
                    .withIlluminance(1000 * random.nextDouble() + 1e-3);
            double range = 3000 * random.nextDouble();
            double crossing = 300 * random.nextDouble();
            int pixels = random.nextInt(5000);
            TargetTask task = TargetTask.DEFAULT.withContrast(0.01 + 0.9 * random.nextDouble());
            double background = random.nextBoolean() ? SKY : 5000 * random.nextDouble();
            DroneView view = new DroneView(pixels, range, 3000, crossing, light, SKY, GREEN, background);

            double seen = task.contrast() * light.contrastLeft(range);
            double needed = 0.02 * Math.sqrt(Math.max(1.0, 100.0 / light.illuminance()));
            double blur = crossing * 0.01;
            double before = seen > needed
                    ? 0.5 * Math.sqrt(pixels) * (1.0 - needed / seen) / Math.sqrt(Math.sqrt(1.0 + blur * blur))
                    : 0.0;
            assertThat(task.resolved(view)).as("seed 25, number %d", i).isEqualTo(before);
        }
    }

    /**
     * 2.2 degrees over 1920 pixels at 723 m: what is left of the resolution. The figures are those of {@link #finest},
     * relative to still air and a perfect lens.
     */
    @ParameterizedTest
    @CsvSource({"0, 0, 1", "1e-14, 0, 0.97953", "1e-13, 0, 0.69067", "0, 0.027, 0.94027", "1e-13, 0.027, 0.62515"})
    void turbulenceAndDiffractionTakeDetail(double cn2, double aperture, double left) {
        Lens lens = aperture == 0.0 ? GREEN : new Lens(OptionalDouble.of(aperture), 550e-9);
        double sharp = TargetTask.DEFAULT.resolved(view(723, Light.DAY, GREEN, SKY));

        assertThat(TargetTask.DEFAULT.resolved(view(723, Light.DAY.withCn2(cn2), lens, SKY)) / sharp)
                .isCloseTo(left, within(1e-5));
        assertThat(finest(cn2, aperture) / finest(0.0, 0.0)).isCloseTo(left, within(1e-5));
    }

    /**
     * The finest pattern that is resolved, as a fraction u of half a line pair per pixel, by halving
     * {@code C M(u) (1 - u) = Ct}: C is a contrast of 0.5 after 723 m of air of 20 km visibility, Ct = 0.02. M is the
     * product of the long-exposure transfer function of a spherical wave, {@code exp(-3.44 (lambda f / r0)^(5/3))} with
     * {@code r0 = (3/8 0.423 k^2 Cn2 L)^(-3/5)} (Fried 1966), and of that of a circular aperture (Goodman, Fourier
     * Optics, section 6.3).
     */
    private static double finest(double cn2, double aperture) {
        double contrast = 0.5 * Math.pow(0.05, 723.0 / 20_000.0);
        double low = 0.0;
        double high = 1.0;
        for (int i = 0; i < 60; i++) {
            double middle = 0.5 * (low + high);
            boolean isResolved = contrast * transferred(middle, cn2, aperture) * (1.0 - middle) > 0.02;
            low = isResolved ? middle : low;
            high = isResolved ? high : middle;
        }
        return low;
    }

    private static double transferred(double fraction, double cn2, double aperture) {
        double wavelength = 550e-9;
        double cyclesPerRadian = fraction * 0.5 * 960.0 / Math.tan(Math.toRadians(1.1));
        double wave = 2.0 * Math.PI / wavelength;
        double spread = Math.pow(0.375 * 0.423 * wave * wave * cn2 * 723.0, 0.6);
        double air = Math.exp(-3.44 * Math.pow(wavelength * cyclesPerRadian * spread, 5.0 / 3.0));
        double x = aperture == 0.0 ? 0.0 : wavelength * cyclesPerRadian / aperture;
        return x >= 1.0 ? 0.0 : air * 2.0 / Math.PI * (Math.acos(x) - x * Math.sqrt(1.0 - x * x));
    }

    private static DroneView look(World world, Position camera, Position drone) {
        List<DroneView> views = new ArrayList<>();
        CameraSettings settings = CameraSettings.at(camera)
                .withLookAt(drone)
                .withResolution(400, 300)
                .withAperture(0.03)
                .withWavelength(850e-9)
                .withDetection(new ViewRecorder(views));
        TriangleMesh box = Shapes.box(new Position(-0.3, -0.3, -0.3), new Position(0.3, 0.3, 0.3));
        Drone flying = new Drone(
                        "drone",
                        DroneSettings.of(ModelSettings.of("drone.obj"), Hover.at(new Position(0, 0, 0))),
                        KDTree.of(box))
                .at(new FlightState(drone, new Position(0, 0, 0), 0.0));
        settings.create().observe(world, List.of(flying), Look.of(1, "camera", 0, 0.0));
        return views.get(0);
    }

    @Test
    void whatTheRayBehindTheDroneMeetsIsItsBackground() {
        World world = World.of(World.merge(List.of(
                Shapes.ground(100, 0),
                Shapes.rectangle(new Position(-20, 40, 0), new Position(20, 40, 0), new Position(20, 40, 30)))));
        Position low = new Position(0, 0, 2);
        Position high = new Position(0, 0, 20);

        assertThat(look(world, low, new Position(0, 20, 10)).background())
                .as("a wall 20 m behind it, in the horizontal")
                .isCloseTo(20 * Math.hypot(20, 8) / 20, within(1e-4));
        assertThat(look(world, low, new Position(0, 20, 25)).background())
                .as("over the wall")
                .isEqualTo(SKY);
        assertThat(look(world, low, new Position(20, -20, 2)).background())
                .as("level, to the horizon")
                .isEqualTo(SKY);
        assertThat(look(world, high, new Position(0, -20, 10)).background())
                .as("down to the ground")
                .isCloseTo(Math.hypot(20, 10), within(1e-4));
        assertThat(look(world, high, new Position(0, -40, 18)).background())
                .as("beyond the edge of the site, 360 m behind")
                .isCloseTo(9 * Math.hypot(40, 2), within(1e-3));
        assertThat(look(world, low, new Position(0, -20, 0.3)).background())
                .as("standing on the ground")
                .isCloseTo(0.3 / 1.7 * Math.hypot(20, 1.7), within(1e-4));
        assertThat(look(world, high, new Position(0, -20, -3)).background())
                .as("hidden below the ground: no view")
                .isEqualTo(SKY);
    }

    /** The ground beyond the site lies at the height of its lowest point, 30 m below the ground of the others. */
    @Test
    void beyondTheSiteTheGroundLiesAtItsLowestPoint() {
        World deep = World.of(Shapes.ground(100, -30));
        World high = World.of(Shapes.ground(100, 12));

        assertThat(look(deep, new Position(0, 0, 20), new Position(0, -80, 10)).background())
                .as("10 m down in 80 m, 40 m more to the ground")
                .isCloseTo(4 * Math.hypot(80, 10), within(1e-3));
        assertThat(look(high, new Position(0, 0, 32), new Position(0, -80, 22)).background())
                .as("10 m more to the ground")
                .isCloseTo(Math.hypot(80, 10), within(1e-3));
    }

    @Test
    void aCameraShowsItsLens() {
        Lens lens = look(World.of(Shapes.ground(100, 0)), new Position(0, 0, 2), new Position(0, 20, 10))
                .lens();

        assertThat(lens.aperture()).hasValue(0.03);
        assertThat(lens.wavelength()).isEqualTo(850e-9);
        assertThat(CameraSettings.at(new Position(0, 0, 2)).lens()).isEqualTo(GREEN);
    }

    @Test
    void limitsOfAirAndLensAreChecked() {
        CameraSettings camera = CameraSettings.at(new Position(0, 0, 2));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Light.DAY.withCn2(1e-9))
                .withMessageContaining("cn2");
        assertThatIllegalArgumentException().isThrownBy(() -> Light.DAY.withCn2(-1e-16));
        assertThatIllegalArgumentException().isThrownBy(() -> Light.DAY.withSkyToGroundRatio(0.0));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> camera.withAperture(0.0))
                .withMessageContaining("aperture");
        assertThatIllegalArgumentException().isThrownBy(() -> camera.withWavelength(1.0));
        assertThatIllegalArgumentException().isThrownBy(() -> TargetTask.DEFAULT.withGroundContrast(0.0));
    }
}
