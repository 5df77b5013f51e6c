package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.Attitude;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.optics.*;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Tracing the significant pixels only must give what tracing every pixel gives. */
class DynamicViewTest {
    private static final int WIDTH = 160;
    private static final int HEIGHT = 90;

    private final CameraSensor camera = CameraSettings.at(new Position(0, 0, 2))
            .withLookAt(new Position(0, 10, 2))
            .withResolution(WIDTH, HEIGHT)
            .withVerticalFov(1.0)
            .create();
    private final World ground = World.of(Shapes.ground(200, 0));
    private final TriangleMesh ball = Shapes.sphere(0.5, 3);
    private final TriangleMesh plank = Shapes.box(new Position(-2, -0.1, -0.1), new Position(2, 0.1, 0.1));

    /** Checks counts, marks and distances, and gives the count of each drone. */
    private List<Integer> counts(World world, List<Drone> drones) {
        FullRetrace expected = new FullRetrace(camera.camera(), world, drones);
        List<Observation> observations = camera.observe(world, drones, Look.of(1, "camera", 0, 0.0));
        List<Integer> counts = new ArrayList<>();
        for (int i = 0; i < drones.size(); i++) {
            assertThat((int) observations.get(i).value()).isEqualTo(expected.pixels(i));
            counts.add(expected.pixels(i));
        }
        DepthImage image = camera.depthImage(world, drones);
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            assertThat(image.isHit(pixel % WIDTH, pixel / WIDTH)).isEqualTo(expected.isHit(pixel));
            assertThat(image.distance(pixel % WIDTH, pixel / WIDTH)).isEqualTo(expected.distance(pixel));
        }
        return counts;
    }

    private int count(World world, Drone drone) {
        return counts(world, List.of(drone)).get(0);
    }

    @Test
    void inTheOpen() {
        assertThat(count(ground, Shapes.drone("ball", ball, new Position(0.3, 5, 2.2))))
                .isGreaterThan(100);
    }

    @Test
    void halfBehindAWall() {
        Drone drone = Shapes.drone("ball", ball, new Position(0, 6, 2));
        World walled =
                World.of(Shapes.rectangle(new Position(0, 4, -1), new Position(9, 4, -1), new Position(9, 4, 9)));

        int open = count(ground, drone);
        assertThat(count(walled, drone)).isBetween(open / 2 - open / 20, open / 2 + open / 20);
    }

    @Test
    void straddlingTheCameraPlane() {
        Drone along = Shapes.drone("plank", plank, new Position(0.3, 0, 2.3)).rotateZ(Math.PI / 2, 1);
        assertThat(count(ground, along)).isPositive();
        Drone aslant = Shapes.drone("plank", plank, new Position(0.2, 0.3, 1.8)).rotateZ(0.4, 1);
        assertThat(count(ground, aslant)).isPositive();
    }

    @Test
    void aroundTheCamera() {
        assertThat(count(ground, Shapes.drone("ball", ball, new Position(0, 0.1, 2))))
                .isEqualTo(WIDTH * HEIGHT);
    }

    @Test
    void touchingTheCamera() {
        assertThat(count(ground, Shapes.drone("ball", ball, new Position(0, 0.5 + 1e-4, 2))))
                .isPositive();
    }

    @Test
    void partlyOutsideTheFrame() {
        for (Position place : List.of(
                new Position(4.5, 5, 2),
                new Position(-4.5, 5, 2),
                new Position(0, 5, 4.6),
                new Position(4.5, 5, 4.6))) {
            assertThat(count(ground, Shapes.drone("ball", ball, place))).isPositive();
        }
    }

    @Test
    void outOfSight() {
        for (Position place : List.of(
                new Position(0, -5, 2), new Position(30, 5, 2), new Position(0, 5, -3), new Position(0, -0.6, 2))) {
            assertThat(count(ground, Shapes.drone("ball", ball, place))).isZero();
        }
    }

    @Test
    void inFrontOfAnotherDrone() {
        Drone near = Shapes.drone("near", ball, new Position(0.4, 5, 2));
        Drone far = Shapes.drone("far", plank, new Position(0, 8, 2.1));
        int alone = count(ground, far);

        List<Integer> nearFirst = counts(ground, List.of(near, far));
        List<Integer> farFirst = counts(ground, List.of(far, near));

        assertThat(nearFirst.get(0)).isEqualTo(count(ground, near));
        assertThat(nearFirst.get(1)).isPositive().isLessThan(alone);
        assertThat(farFirst).containsExactly(nearFirst.get(1), nearFirst.get(0));
    }

    /** One sensor over many frames: what it remembers of one frame must not show in the next. */
    @Test
    void tumblingDronesFrameAfterFrame() {
        long seed = 20260301L;
        Random random = new Random(seed);
        Drone first = Shapes.drone("first", plank, new Position(0, 3, 2));
        Drone second = Shapes.drone("second", ball, new Position(0, 3, 2));
        int seen = 0;
        for (int frame = 0; frame < 60; frame++) {
            List<Drone> drones = frame % 7 == 3
                    ? List.of(Shapes.tumbled(second, 9, random))
                    : List.of(Shapes.tumbled(first, 9, random), Shapes.tumbled(second, 9, random));
            seen += counts(ground, drones).stream().anyMatch(count -> count > 0) ? 1 : 0;
        }
        assertThat(seen).as("frames with a drone, seed %d", seed).isGreaterThan(20);
    }

    /** Yaw, pitch and roll of a flight's states, as a path of a user's own or one that leans gives them. */
    @Test
    void dronesAtEveryAttitudeOfTheirFlight() {
        long seed = 20260302L;
        System.out.println("seed of the attitudes: " + seed);
        Random random = new Random(seed);
        Position rest = new Position(0, 0, 0);
        Drone drone = Shapes.drone("plank", plank, rest);
        for (int i = 0; i < 60; i++) {
            Position place = new Position(random.nextDouble(-2, 2), random.nextDouble(4, 9), random.nextDouble(1, 3));
            Attitude attitude =
                    new Attitude(random.nextDouble(-7, 7), random.nextDouble(-7, 7), random.nextDouble(-7, 7));
            assertThat(count(ground, drone.at(new FlightState(place, rest, attitude))))
                    .as("%s", attitude)
                    .isPositive();
        }
    }

    /** Turning the camera is the same as turning everything else: all directions of view must work. */
    @Test
    void camerasThatLookAnywhere() {
        long seed = 7L;
        Random random = new Random(seed);
        Position place = new Position(0, 0, 2);
        List<Position> ways = new ArrayList<>(List.of(new Position(0, 0, 1), new Position(0, 0, -1)));
        for (int i = 0; i < 20; i++) {
            ways.add(new Position(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()));
        }
        for (Position way : ways) {
            CameraSensor turned = CameraSettings.at(place)
                    .withLookAt(place.plus(way))
                    .withResolution(64, 48)
                    .withHorizontalFov(2.0)
                    .create();
            Drone drone = Shapes.drone("plank", plank, place.plus(way.times(3.0 / way.length())));
            FullRetrace expected = new FullRetrace(turned.camera(), ground, List.of(drone));
            assertThat(turned.pixels(ground, drone))
                    .as("looking along %s, seed %d", way, seed)
                    .isEqualTo(expected.pixels(0));
        }
    }
}
