package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.Walls.behind;
import static org.dronewatch.sensor.Walls.cube;
import static org.dronewatch.sensor.Walls.open;
import static org.dronewatch.sensor.Walls.wall;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Signal;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DronePixels;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** The queries of a camera agree, in whatever order, by whichever sensor, and wherever it is pointed. */
class CameraContractTest {
    private static final World OPEN = open();
    private static final CameraSettings CAMERA = CameraSettings.at(new Position(0, 0, 0));
    private static final double FOCAL = new CameraObject(CAMERA).focalLength();
    private static final Optional<Pointing> AHEAD = Optional.empty();
    private static final Optional<Pointing> EAST =
            Optional.of(Pointing.still(new Direction(Math.PI / 2, 0), CAMERA.fov(), OptionalInt.empty()));

    private static Assessment assess(CameraSensor sensor, World world, Drone drone, Optional<Pointing> pointing) {
        return sensor.assess(world, drone, pointing, new SplittableRandom(1));
    }

    /** A cube of 1 m to the north: a square of as many pixels per side as its front at the focal length. */
    @Test
    void allPixelsOfADroneAreCounted() {
        Drone drone = cube(new Position(0, 20.5, 0));
        double side = FOCAL / 20.0;
        CameraSensor sensor = CAMERA.create();
        Signal signal = sensor.signal(OPEN, drone, AHEAD, new SplittableRandom(1));

        assertThat(signal.quantity()).isCloseTo(side * side, within(2 * side + 1));
        assertThat(sensor.pixels(OPEN, drone)).isEqualTo((int) signal.quantity());
        DronePixels pixels = sensor.pixels(OPEN, List.of(drone)).get(0);
        assertThat(pixels.drone()).isEqualTo(drone.id());
        assertThat(pixels.count()).isEqualTo((int) signal.quantity());
        int hits = 0;
        for (int row = 0; row < CAMERA.height(); row++) {
            for (int column = 0; column < CAMERA.width(); column++) {
                boolean isOfFront = Math.abs(column + 0.5 - 960) < side / 2 && Math.abs(row + 0.5 - 540) < side / 2;
                assertThat(pixels.isHit(column, row)).isEqualTo(isOfFront);
                hits += isOfFront ? 1 : 0;
            }
        }
        assertThat(hits).isEqualTo(pixels.count());
    }

    /** Whatever was asked before, a fresh sensor, its sibling and one that was used for other things agree. */
    @Test
    void answersDoNotDependOnEarlierQuestions() {
        SplittableRandom random = new SplittableRandom(9);
        World world = behind(wall(15, -9, 0.05), ModelRole.TERRAIN);
        World other = OPEN;
        CameraSensor used = CAMERA.withThreshold(40).create();
        List<Cause> causes = new ArrayList<>();
        for (int i = 0; i < 60; i++) {
            double range = random.nextDouble(20, 300);
            double aside = random.nextDouble(-1, 1) * range;
            double above = random.nextDouble(-0.5, 0.5);
            boolean isEast = random.nextBoolean();
            Optional<Pointing> pointing = isEast ? EAST : AHEAD;
            Drone drone = cube(isEast ? new Position(range, aside, above) : new Position(aside, range, above));
            World site = random.nextInt(4) == 0 ? other : world;
            CameraSensor fresh = CAMERA.withThreshold(40).create();
            Assessment one = assess(used, site, drone, pointing);

            String as = "%s, pointed %s".formatted(drone.origin(), pointing);
            assertThat(one).as(as).isEqualTo(assess(fresh, site, drone, pointing));
            assertThat(one).as(as).isEqualTo(assess(used.sibling(), site, drone, pointing));
            assertThat(used.signal(site, drone, pointing, random)).as(as).isEqualTo(one.signal());
            Look look = Look.of(i, "camera", 0, 1.0).withPointing(pointing);
            assertThat(used.observe(site, List.of(drone), look).get(0).value())
                    .as(as)
                    .isEqualTo(one.quantity());
            causes.add(one.cause());
        }
        assertThat(causes).contains(Cause.DETECTED, Cause.OUT_OF_VIEW, Cause.HIDDEN_BY_TERRAIN, Cause.TOO_WEAK);
    }

    /** The reason alone is that of a whole assessment, although no pixels were counted for it before. */
    @Test
    void theReasonForAMissIsThatOfAnAssessment() {
        SplittableRandom random = new SplittableRandom(10);
        World world = behind(wall(15, -9, 0.05), ModelRole.BUILDING);
        CameraSensor used = CAMERA.withThreshold(40).create();
        CameraSensor exact = CAMERA.withThreshold(40).create();
        Drone visible = cube(new Position(0, 10, 0));
        Drone hidden = cube(new Position(0, 100, -2));
        List<Cause> causes = new ArrayList<>();
        for (int i = 0; i < 120; i++) {
            double range = Math.exp(random.nextDouble(3, 8));
            double top = 0.05 / 15 * range;
            Drone drone =
                    cube(new Position(random.nextDouble(-0.8, 0.8) * range, range, top + random.nextDouble(-2, 1)));
            Optional<Pointing> pointing = random.nextInt(8) == 0 ? EAST : AHEAD;
            Assessment one = assess(exact, world, drone, pointing);
            if (one.cause() == Cause.DETECTED) {
                continue;
            }
            String as = "%s, pointed %s".formatted(drone.origin(), pointing);
            Explanation alone = CAMERA.withThreshold(40).create().explainMiss(world, drone, pointing);
            assertThat(alone).as(as).isEqualTo(one.explanation());
            // Whatever was drawn last.
            assess(used, world, random.nextBoolean() ? visible : hidden, pointing);
            assertThat(used.explainMiss(world, drone, pointing)).as(as).isEqualTo(one.explanation());
            causes.add(one.cause());
        }
        assertThat(causes).contains(Cause.OUT_OF_VIEW, Cause.HIDDEN_BY_BUILDING, Cause.TOO_WEAK);
    }

    /** The wall reaches up to the middle of a drone that is too small: it is hidden only if all of it is. */
    @Test
    void aDroneThatIsTooSmallIsHiddenOnlyIfNothingOfItIsVisible() {
        Drone half = cube(new Position(0, 600, 0));
        Drone below = cube(new Position(0, 600, -2));
        World world = behind(wall(20, -9, 0.001), ModelRole.BUILDING);

        assertThat(CAMERA.create().explainMiss(world, half, AHEAD).cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(CAMERA.create().explainMiss(world, below, AHEAD).cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        CameraSensor sensor = CAMERA.create();
        for (Drone drone : List.of(half, below, half, below)) {
            assertThat(sensor.explainMiss(world, drone, AHEAD))
                    .isEqualTo(CAMERA.create().explainMiss(world, drone, AHEAD));
        }
    }

    /** Where a camera says so, every heading and speed gives the same; so it does where no part can be in the image. */
    @Test
    void outsideTheImageHeadingsDoNotMatter() {
        SplittableRandom random = new SplittableRandom(11);
        int outside = 0;
        for (int i = 0; i < 200; i++) {
            Position at =
                    new Position(random.nextDouble(-60, 60), random.nextDouble(-60, 60), random.nextDouble(-9, 9));
            Optional<Pointing> pointing = random.nextBoolean() ? EAST : AHEAD;
            CameraSensor sensor = CAMERA.create();
            boolean isSame = sensor.isSameAtAllHeadings(OPEN, cube(at), pointing);
            if (isSame) {
                Assessment first = assess(sensor, OPEN, cube(at), pointing);
                assertThat(first.quantity()).isZero();
                for (double heading = 0.3; heading < 6; heading += 0.7) {
                    Drone turned = cube(at).at(new FlightState(at, new Position(3, 2, 0), heading));
                    assertThat(assess(sensor, OPEN, turned, pointing)).isEqualTo(first);
                }
                outside++;
            }
            double ahead = pointing == EAST ? at.x() : at.y();
            assertThat(isSame || ahead > -1.0)
                    .as("%s is behind it, pointed %s", at, pointing)
                    .isTrue();
        }
        assertThat(outside).isBetween(100, 180);
        assertThat(CAMERA.create().isSameAtAllHeadings(OPEN, cube(new Position(0, 30, 0)), AHEAD))
                .isFalse();
    }

    /** The blur of a drone that crosses the image fast takes resolution from a task, but no pixels. */
    @Test
    void speedMattersUnlessPixelsAreCounted() {
        Position at = new Position(0, 300, 0);
        Drone slow = cube(at);
        Drone fast = cube(at, new Position(60, 0, 0));
        CameraSensor counting = CAMERA.create();
        CameraSensor performing =
                CAMERA.withDetection(TargetTask.DEFAULT.withExposure(0.1)).create();

        assertThat(counting.isSameAtAllSpeeds()).isTrue();
        assertThat(performing.isSameAtAllSpeeds()).isFalse();
        assertThat(assess(counting, OPEN, fast, AHEAD)).isEqualTo(assess(counting, OPEN, slow, AHEAD));
        assertThat(assess(performing, OPEN, fast, AHEAD).quantity())
                .isLessThan(assess(performing, OPEN, slow, AHEAD).quantity());
    }
}
