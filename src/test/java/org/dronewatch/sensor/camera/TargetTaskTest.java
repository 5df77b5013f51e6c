package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.dronewatch.Wilson;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.Discrimination;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.optics.*;
import org.dronewatch.world.Light;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TargetTaskTest {
    private static final double NO_SUN = Double.POSITIVE_INFINITY;

    /** Everything about the target but its size is perfect. */
    private static final TargetTask PERFECT =
            new TargetTask(Discrimination.DETECTION, 0.5, false, 1.0, Optional.empty(), 1e-9, 1e-3, 0.0, 0.0);

    private static DroneView view(double pixels, double range, double crossing, Light light) {
        return new DroneView((int) Math.round(pixels), range, 1000.0, crossing, light, NO_SUN);
    }

    /**
     * {@code P = x^E / (1 + x^E)}, {@code E = 2.7 + 0.7 x} (Howe, The Infrared and Electro-Optical Systems Handbook,
     * vol. 4, 1993). By hand at x = 0.5: E = 3.05, 0.5^3.05 = 0.12074, P = 0.12074 / 1.12074 = 0.1077.
     */
    @ParameterizedTest
    @CsvSource({"0.5, 0.1077", "0.75, 0.2834", "1, 0.5", "1.5, 0.8206", "1.75, 0.8999", "2, 0.9449", "3, 0.9949", "0, 0"
    })
    void theTransferFunctionHasItsPublishedForm(double ratio, double probability) {
        assertThat(Discrimination.transfer(ratio)).isCloseTo(probability, within(5.1e-5));
    }

    @Test
    void theTransferFunctionRisesFromNoneToCertain() {
        double last = 0.0;
        for (double ratio = 0.0; ratio < 1e4; ratio = 1.1 * ratio + 0.01) {
            double now = Discrimination.transfer(ratio);
            assertThat(now).isBetween(last, 1.0);
            last = now;
        }
        assertThat(last).isEqualTo(1.0);
    }

    /**
     * Pixels across the root of the area for a probability of 0.9: 1.75 times the two pixels of each of Johnson's 1, 4
     * and 6.4 line pairs, of which an area takes three quarters (Kennedy, SPIE 1488, 1991).
     */
    @ParameterizedTest
    @CsvSource({"DETECTION, 2.625", "RECOGNITION, 10.5", "IDENTIFICATION, 16.8"})
    void nineInTenTakeThreeQuartersOfJohnsonsPixels(Discrimination task, double across) {
        TargetTask function = PERFECT.withTask(task);
        double below = function.value(view((across - 0.4) * (across - 0.4), 100, 0, Light.DAY));
        double at = task.probability(0.5 * across);
        double above = function.value(view((across + 0.4) * (across + 0.4), 100, 0, Light.DAY));
        assertThat(at).isCloseTo(0.8999, within(5e-5));
        assertThat(below).isLessThan(0.9);
        assertThat(above).isGreaterThan(0.9);
    }

    /** Koschmieder's law: c^(r/V) of the contrast is left, as in 0.02^(500/5000) = 0.6762. */
    @ParameterizedTest
    @CsvSource({
        "5000, 0.02, 500, 0.6762",
        "5000, 0.02, 1000, 0.4573",
        "5000, 0.05, 500, 0.7411",
        "1000, 0.02, 500, 0.1414",
        "1000, 0.02, 1000, 0.02",
        "1000, 0.05, 1000, 0.05"
    })
    void theAirTakesContrast(double visibility, double definition, double distance, double left) {
        Light light = Light.DAY.withVisibility(visibility).withContrastAtVisibility(definition);
        assertThat(light.contrastLeft(distance)).isCloseTo(left, within(5.1e-5));
    }

    /** The integral over the drops of Marshall and Palmer, each of which takes twice its cross-section. */
    @ParameterizedTest
    @CsvSource({"1, 0.365", "10, 1.556", "50, 4.29"})
    void rainTakesWhatItsDropsCover(double rain, double perKilometre) {
        double step = 1e-6;
        double sum = 0.0;
        for (double d = 0.5 * step; d < 0.02; d += step) {
            double drops = 8e6 * Math.exp(-4100.0 * Math.pow(rain, -0.21) * d);
            sum += 2.0 * Math.PI * d * d / 4.0 * drops * step;
        }
        assertThat(1000.0 * sum).isCloseTo(perKilometre, within(0.002 * perKilometre));
        Light dry = Light.DAY.withVisibility(5000);
        double left = dry.inRain(rain).contrastLeft(700);
        assertThat(left / dry.contrastLeft(700)).isCloseTo(Math.exp(-700 * sum), within(1e-4));
        assertThat(dry.inRain(0)).isSameAs(dry);
    }

    @Test
    void aCameraSeesThroughTheRainOfItsWorld() {
        World wet = World.of(Shapes.ground(100, 0)).withRain(20);
        DroneView view = look(wet, new Position(0, 20, 2), new Position(0, 0, 0));

        assertThat(view.light()).isEqualTo(Light.DAY.inRain(20));
        assertThat(view.light().visibility()).isBetween(1100.0, 1300.0);
    }

    @Test
    void fogDarknessAndBlurTakeResolution() {
        TargetTask function = TargetTask.DEFAULT;
        Light fog = Light.DAY.withVisibility(500);
        double clear = function.resolved(view(400, 300, 0, Light.DAY));
        assertThat(clear).isBetween(9.0, 10.0);
        assertThat(function.resolved(view(400, 300, 0, fog))).isBetween(0.3 * clear, 0.9 * clear);
        assertThat(function.resolved(view(400, 600, 0, fog)))
                .as("its contrast is below 2 %")
                .isZero();
        // A hundredth of the light takes ten times the contrast.
        Light dusk = Light.DAY.withIlluminance(1.0);
        double seen = 0.5 * Light.DAY.contrastLeft(300);
        assertThat(function.resolved(view(400, 300, 0, dusk))).isCloseTo(10.0 * (1 - 0.2 / seen), within(1e-9));
        assertThat(function.resolved(view(400, 300, 0, Light.DAY.withIlluminance(0.01))))
                .isZero();
        // 300 pixels a second for a hundredth of one: three pixels of blur, in one of two directions.
        double blurred = function.resolved(view(400, 300, 300, Light.DAY));
        assertThat(blurred).isCloseTo(clear / Math.pow(10.0, 0.25), within(1e-9));
    }

    @Test
    void chanceIsAMatterOfEncounters() {
        assertThat(TargetTask.DEFAULT.withChance(true).chance()).isEqualTo(Chance.PER_ENCOUNTER);
        assertThat(TargetTask.DEFAULT.withChance(true).threshold()).isEqualTo(0.5);
        assertThat(TargetTask.DEFAULT.chance()).isEqualTo(Chance.PER_LOOK);
        assertThat(new PixelThreshold(12).chance()).isEqualTo(Chance.PER_LOOK);
        CameraSettings camera = CameraSettings.at(new Position(0, 0, 2));
        assertThat(camera.withDetection(TargetTask.DEFAULT.withChance(true)).chance())
                .isEqualTo(Chance.PER_ENCOUNTER);
        assertThat(camera.chance()).isEqualTo(Chance.PER_LOOK);
    }

    /** Printed values: 90 of 100, 0 of 100 and all of 100 at 95 %. */
    @ParameterizedTest
    @CsvSource({"90, 0.8256, 0.9448", "0, 0, 0.0370", "100, 0.9630, 1"})
    void theIntervalIsWilsons(int hits, double low, double high) {
        double[] interval = Wilson.interval(hits, 100, 1.959964);
        assertThat(interval[0]).isCloseTo(low, within(5.1e-5));
        assertThat(interval[1]).isCloseTo(high, within(5.1e-5));
    }

    private static DroneView look(World world, Position drone, Position velocity) {
        return look(world, drone, velocity, Optional.empty());
    }

    private static DroneView look(World world, Position drone, Position velocity, Optional<Pointing> pointing) {
        List<DroneView> views = new ArrayList<>();
        CameraSettings settings = CameraSettings.at(new Position(0, 0, 2))
                .withLookAt(new Position(0, 10, 2))
                .withResolution(400, 300)
                .withDetection(new ViewRecorder(views));
        TriangleMesh box = Shapes.box(new Position(-0.3, -0.3, -0.3), new Position(0.3, 0.3, 0.3));
        Drone flying = new Drone(
                        "drone",
                        DroneSettings.of(ModelSettings.of("drone.obj"), Hover.at(new Position(0, 0, 0))),
                        KDTree.of(box))
                .at(new FlightState(drone, velocity, 0.0));
        List<Observation> observations = settings.create()
                .observe(world, List.of(flying), Look.of(1, "camera", 0, 0.0).withPointing(pointing));
        assertThat(observations).hasSize(1);
        return views.get(0);
    }

    @Test
    void aCameraTellsHowFastTheDroneCrossesItsPicture() {
        World world = World.of(Shapes.ground(100, 0));
        double focal =
                new CameraObject(CameraSettings.at(new Position(0, 0, 2)).withResolution(400, 300)).focalLength();
        Position ahead = new Position(0, 20, 2);

        assertThat(look(world, ahead, new Position(0, -8, 0)).crossing()).isCloseTo(0.0, within(1e-9));
        assertThat(look(world, ahead, new Position(6, 0, 0)).crossing()).isCloseTo(6.0 / 20 * focal, within(1e-6));
        assertThat(look(world, ahead, new Position(3, -8, 4)).crossing()).isCloseTo(5.0 / 20 * focal, within(1e-6));
        assertThat(look(world, new Position(0, -20, 2), new Position(6, 0, 0)).pixels())
                .isZero();
    }

    @Test
    void aMountThatTurnsWithTheDroneTakesItsCrossingAwayAndGivesItsOwn() {
        World world = World.of(Shapes.ground(100, 0));
        CameraSettings camera = CameraSettings.at(new Position(0, 0, 2)).withResolution(400, 300);
        double focal = camera.focalLength();
        Position ahead = new Position(0, 20, 2);
        Direction north = new Direction(0, 0);
        double pan = 6.0 / 20;
        Pointing with = new Pointing(north, pan, 0.0, camera.fov(), OptionalInt.of(1));
        Pointing slewing = new Pointing(north, 1.0, -0.5, camera.fov(), OptionalInt.of(1));

        assertThat(look(world, ahead, new Position(6, 0, 0), Optional.of(with)).crossing())
                .isCloseTo(0.0, within(1e-6));
        assertThat(look(world, ahead, new Position(6, 0, 2), Optional.of(with)).crossing())
                .isCloseTo(2.0 / 20 * focal, within(1e-6));
        assertThat(look(world, ahead, new Position(0, 0, 0), Optional.of(slewing))
                        .crossing())
                .isCloseTo(Math.hypot(1.0, 0.5) * focal, within(1e-6));
    }

    @Test
    void theSunBlindsUnlessSomethingStandsBeforeIt() {
        Position ahead = new Position(0, 20, 2);
        Light low = Light.DAY.withSun(new Light.Sun(Math.toRadians(3), Math.toRadians(1)));
        World open = World.of(Shapes.ground(100, 0)).withLight(low);
        DroneView blinding = look(open, ahead, new Position(0, 0, 0));
        assertThat(blinding.sunAngle()).isCloseTo(Math.toRadians(Math.sqrt(10)), within(1e-4));
        assertThat(TargetTask.DEFAULT.value(blinding)).isZero();
        assertThat(TargetTask.DEFAULT.value(new DroneView(blinding.pixels(), 20, 1000, 0, low, Math.toRadians(8))))
                .isGreaterThan(0.9);

        TriangleMesh wall = World.merge(List.of(
                Shapes.ground(100, 0),
                Shapes.rectangle(new Position(-20, 40, 0), new Position(20, 40, 0), new Position(20, 40, 30))));
        DroneView shaded = look(World.of(wall).withLight(low), ahead, new Position(0, 0, 0));
        assertThat(shaded.sunAngle()).isEqualTo(Double.POSITIVE_INFINITY);

        Light night = Light.DAY.withSun(new Light.Sun(0, -0.1));
        assertThat(look(
                                World.of(Shapes.rectangle(
                                                new Position(-1, 200, 0),
                                                new Position(1, 200, 0),
                                                new Position(1, 200, 1)))
                                        .withLight(night),
                                ahead,
                                new Position(0, 0, 0))
                        .sunAngle())
                .as("a sun below the horizon")
                .isEqualTo(Double.POSITIVE_INFINITY);
    }

    /** Half of the sun is above the horizon; one whose centre is a hair below is not seen, whatever its size. */
    @Test
    void theSunBlindsDownToTheHorizon() {
        World field = World.of(
                Shapes.rectangle(new Position(-50, -50, 0), new Position(50, -50, 0), new Position(50, -45, 0)));
        Position ahead = new Position(0, 20, 2);
        Light rising = Light.DAY.withSun(new Light.Sun(0, 0));
        Light below = Light.DAY.withSun(new Light.Sun(0, -1e-9));

        DroneView blinding = look(field.withLight(rising), ahead, new Position(0, 0, 0));
        assertThat(blinding.sunAngle()).isCloseTo(0.0, within(1e-7));
        assertThat(TargetTask.DEFAULT.value(blinding)).isZero();
        assertThat(look(field.withLight(below), ahead, new Position(0, 0, 0)).sunAngle())
                .isEqualTo(Double.POSITIVE_INFINITY);
    }

    /** An exclusion angle excludes what is within it, not what is at it; 0 excludes nothing. */
    @Test
    void withoutAnExclusionAngleTheSunDoesNotBlind() {
        assertThat(PERFECT.resolved(new DroneView(400, 100, 1000, 0, Light.DAY, 0.0)))
                .isEqualTo(PERFECT.resolved(view(400, 100, 0, Light.DAY)));
        double glare = TargetTask.DEFAULT.sunExclusionAngle();
        assertThat(TargetTask.DEFAULT.resolved(new DroneView(400, 100, 1000, 0, Light.DAY, glare)))
                .isPositive();
        assertThat(TargetTask.DEFAULT.resolved(new DroneView(400, 100, 1000, 0, Light.DAY, Math.nextDown(glare))))
                .isZero();
    }

    @Test
    void limitsAreChecked() {
        assertThatIllegalArgumentException().isThrownBy(() -> TargetTask.DEFAULT.withProbability(1.0));
        assertThatIllegalArgumentException().isThrownBy(() -> TargetTask.DEFAULT.withContrast(0.0));
        assertThatIllegalArgumentException().isThrownBy(() -> TargetTask.DEFAULT.withExposure(2.0));
        assertThatIllegalArgumentException().isThrownBy(() -> Light.DAY.withVisibility(0.0));
        assertThatIllegalArgumentException().isThrownBy(() -> Light.DAY.withContrastAtVisibility(0.5));
    }
}
