package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.DoubleToIntFunction;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.AssessmentBounds;
import org.dronewatch.sensor.Cause;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Bounds of a function for which a drone without a pixel may be better than one with a few. */
class SteadyPictureTest {
    private static final World OPEN = open();
    private static final World WALL = behind(wall(40, -99, 0.4), ModelRole.BUILDING);
    private static final CameraSettings CAMERA =
            CameraSettings.at(new Position(0, 0, 0)).withResolution(960, 540);
    private static final Drone CUBE = cube(new Position(0, 0, 0));
    private static final DoubleToIntFunction STEPS = p -> (int) Math.rint(250 * p);

    /** Few triangles: no pixel is traced alone, so it is often open whether there is one at all. */
    @ParameterizedTest
    @CsvSource({"40", "60", "75", "90"})
    void boundsHoldThoughAPixelMayBeWorseThanNone(double threshold) {
        SplittableRandom random = new SplittableRandom(31);
        CameraSettings camera = CAMERA.withDetection(new Steady(threshold));
        for (World world : new World[] {OPEN, WALL}) {
            CameraSensor bounding = camera.create();
            CameraSensor exact = camera.create();
            int decided = 0;
            for (int i = 0; i < 300; i++) {
                double range = 60.0 * Math.exp(random.nextDouble(2.5));
                Position at = new Position(0.6 * range * random.nextDouble(-1, 1), range, random.nextDouble(-2, 6));
                Position velocity = new Position(random.nextDouble(0.05) * range, 0, 0);
                FlightState state = new FlightState(at, velocity, random.nextDouble(6.2));
                Assessment one = exact.assess(world, CUBE.at(state), Optional.empty(), random);
                Optional<AssessmentBounds> bounds = bounding.bound(world, CUBE, state, Optional.empty(), STEPS);
                String as = "number %d, %s".formatted(i, state);
                bounds.ifPresent(there -> {
                    assertThat(there.cause()).as(as).isEqualTo(one.cause());
                    assertThat(one.probability()).as(as).isBetween(there.least(), there.greatest());
                    assertThat(one.marginDb()).as(as).isBetween(there.leastMarginDb(), there.greatestMarginDb());
                });
                decided += bounds.isPresent() ? 1 : 0;
            }
            assertThat(decided).isPositive();
        }
    }

    /** It hovers, and a pixel is worth more than none: both suffice, and nobody knows its silhouette yet. */
    @Test
    void whereNothingIsNeededADroneIsDetected() {
        FlightState still = new FlightState(new Position(0, 300, 0), new Position(0, 0, 0), 0.4);
        CameraSensor sensor = CAMERA.withDetection(new Steady(60)).create();
        Drone unknown = cube(still.position());
        AssessmentBounds bounds =
                sensor.bound(OPEN, unknown, still, Optional.empty(), STEPS).orElseThrow();

        assertThat(bounds.cause()).isEqualTo(Cause.DETECTED);
        assertThat(bounds.leastMarginDb()).isCloseTo(10 * Math.log10(70.0 / 60.0), within(1e-12));
    }

    /** Where the signal without a pixel depends on the range, so do bounds, one after the other. */
    @Test
    void boundsOfOnePlaceAreNotThoseOfAnother() {
        CameraSensor sensor = CAMERA.withDetection(new Steady(95)).create();
        Position near = new Position(0, -20, 0);
        Position far = new Position(0, -200, 0);

        assertThat(sensor.boundAtAllHeadings(OPEN, CUBE, near, Optional.empty())
                        .orElseThrow()
                        .cause())
                .isEqualTo(Cause.DETECTED);
        AssessmentBounds bounds =
                sensor.boundAtAllHeadings(OPEN, CUBE, far, Optional.empty()).orElseThrow();
        assertThat(bounds.cause()).isEqualTo(Cause.OUT_OF_VIEW);
        assertThat(bounds.greatestMarginDb()).isCloseTo(10 * Math.log10(80.0 / 95.0), within(1e-12));
    }
}
