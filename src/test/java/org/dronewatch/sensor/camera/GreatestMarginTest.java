package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.ArrayList;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import java.util.function.DoubleToIntFunction;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** The upper bound on the margin, which needs no picture: that of a drone that fills the square around it. */
class GreatestMarginTest {
    private static final World OPEN = open();
    private static final World WALL = behind(wall(40, -99, 0.4), ModelRole.BUILDING);
    private static final CameraSettings CAMERA =
            CameraSettings.at(new Position(0, 0, 0)).withResolution(960, 540);
    private static final double FOCAL = CAMERA.focalLength();
    private static final Drone BALL = Shapes.drone("drone", Shapes.sphere(0.5, 4), new Position(0, 0, 0));
    private static final Drone CUBE = cube(new Position(0, 0, 0));
    private static final DoubleToIntFunction STEPS = p -> (int) Math.rint(250 * p);

    /**
     * No drone has a greater margin than one that fills the square around its sphere, here with a diameter of the root
     * of three metres; no drone on any heading has a greater margin than stated.
     */
    @Test
    void theGreatestMarginIsThatOfTheSquareAroundADrone() {
        SplittableRandom random = new SplittableRandom(23);
        CameraSensor sensor = CAMERA.create();
        CameraSensor other = CAMERA.create();
        CameraSensor drawing = CAMERA.create();
        for (int i = 0; i < 200; i++) {
            double range = random.nextDouble(60, 400);
            Position at =
                    new Position(random.nextDouble(-0.2, 0.2) * range, range, random.nextDouble(-0.1, 0.1) * range);
            FlightState state = new FlightState(at, new Position(9, 0, 0), random.nextDouble(6.2));
            double greatest = sensor.greatestMarginDb(WALL, CUBE, state, Optional.empty());

            assertThat(drawing.signal(OPEN, CUBE.at(state), Optional.empty(), random)
                            .marginDb())
                    .isLessThanOrEqualTo(greatest);
            double obliqueness = 1.0 + 0.2 * 0.2 + 0.1 * 0.1;
            double side = Math.sqrt(3.0) * FOCAL / (range - 1.0) * obliqueness + 1.0;
            assertThat(greatest).isLessThan(10 * Math.log10(side * side / 12));
            other.bound(WALL, CUBE, state, Optional.empty(), STEPS);
            assertThat(other.greatestMarginDb(WALL, CUBE, state, Optional.empty()))
                    .as("whatever was examined before")
                    .isEqualTo(greatest);
        }
    }

    @Test
    void theGreatestMarginIsUnknownCloseToTheCameraAndForFunctionsThatNeedNotGrow() {
        FlightState around = new FlightState(new Position(0, 0.5, 0), new Position(0, 0, 0), 0.0);
        FlightState ahead = new FlightState(new Position(0, 60, 0), new Position(0, 0, 0), 0.0);
        CameraSettings any = CAMERA.withDetection(new ViewRecorder(new ArrayList<>()));

        assertThat(CAMERA.create().greatestMarginDb(OPEN, CUBE, around, Optional.empty()))
                .isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(any.create().greatestMarginDb(OPEN, CUBE, ahead, Optional.empty()))
                .isEqualTo(Double.POSITIVE_INFINITY);
        assertThat(any.create().bound(OPEN, CUBE, ahead, Optional.empty(), STEPS))
                .isEmpty();
    }

    /** A ball of one metre that fills as many pixels as a disk: its square is 4 / pi times as many. */
    @Test
    void theGreatestMarginFollowsAPositioner() {
        Optional<Pointing> east =
                Optional.of(Pointing.still(new Direction(Math.PI / 2, 0), CAMERA.fov(), OptionalInt.empty()));
        FlightState state = new FlightState(new Position(50, 0, 0), new Position(0, 0, 0), 0.0);
        CameraSensor sensor = CAMERA.create();
        double side = FOCAL / 50;

        assertThat(sensor.greatestMarginDb(OPEN, BALL, state, east))
                .isCloseTo(10 * Math.log10(side * side / 12), within(1.2));
        FlightState aside = new FlightState(new Position(90, 60, 0), new Position(0, 0, 0), 0.0);
        assertThat(sensor.greatestMarginDb(OPEN, BALL, aside, Optional.empty()))
                .as("outside the image")
                .isEqualTo(Double.NEGATIVE_INFINITY);
    }
}
