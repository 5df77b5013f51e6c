package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalInt;
import java.util.Random;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.Ray;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.optics.*;
import org.dronewatch.world.World;
import org.jogamp.vecmath.AxisAngle4d;
import org.jogamp.vecmath.Matrix4d;
import org.jogamp.vecmath.Point2d;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;

/** Cameras that are turned about their axis, and lenses that are shifted across it. */
class RolledCameraTest {
    private static final int SIDE = 96;
    private static final CameraSettings LEVEL = CameraSettings.at(new Position(0, 0, 2))
            .withLookAt(new Position(1, 10, 2.5))
            .withResolution(SIDE, SIDE)
            .withVerticalFov(1.0);

    private final World ground = World.of(Shapes.ground(200, 0));
    private final TriangleMesh ball = Shapes.sphere(0.5, 3);
    private final TriangleMesh plank = Shapes.box(new Position(-2, -0.1, -0.1), new Position(2, 0.1, 0.1));

    private static Position unit(Random random) {
        return new Position(random.nextGaussian(), random.nextGaussian(), random.nextGaussian()).unit();
    }

    private List<Drone> drones(Random random) {
        List<Drone> drones = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            Position place =
                    new Position(random.nextDouble(-3, 4), random.nextDouble(6, 12), random.nextDouble(0.5, 5));
            drones.add(Shapes.drone("drone " + i, i % 2 == 0 ? plank : ball, place)
                    .rotateZ(random.nextDouble(7), 1)
                    .rotateX(random.nextDouble(7), 1));
        }
        return drones;
    }

    /** A quarter turn of the camera, right side down, is a quarter turn of the picture, counterclockwise. */
    @Test
    void quarterTurnsOfTheCameraAreQuarterTurnsOfThePicture() {
        long seed = 31_415;
        System.out.println("seed of the scenes: " + seed);
        Random random = new Random(seed);
        int hits = 0;
        for (int scene = 0; scene < 10; scene++) {
            List<Drone> drones = drones(random);
            CameraSettings aimed = LEVEL.withLookAt(
                    LEVEL.position().plus(new Position(0, 10, 0)).plus(unit(random)));
            CameraSensor level = aimed.create();
            DepthImage upright = level.depthImage(ground, drones);
            hits += upright.hitCount();
            for (int quarters : new int[] {1, 2, 3, -1, 4}) {
                CameraSensor rolled =
                        aimed.withRoll(Math.toRadians(90.0 * quarters)).create();
                DepthImage turned = rolled.depthImage(ground, drones);
                double[] expected = new double[3];
                double[] direction = new double[3];
                for (int row = 0; row < SIDE; row++) {
                    for (int column = 0; column < SIDE; column++) {
                        int fromColumn = column;
                        int fromRow = row;
                        for (int i = 0; i < Math.floorMod(quarters, 4); i++) {
                            int last = fromColumn;
                            fromColumn = SIDE - 1 - fromRow;
                            fromRow = last;
                        }
                        level.camera().direction(fromColumn, fromRow, expected);
                        rolled.camera().direction(column, row, direction);
                        assertThat(direction).isEqualTo(expected);
                        assertThat(turned.distance(column, row)).isEqualTo(upright.distance(fromColumn, fromRow));
                        assertThat(turned.isHit(column, row)).isEqualTo(upright.isHit(fromColumn, fromRow));
                    }
                }
                for (int i = 0; i < drones.size(); i++) {
                    assertThat(rolled.pixels(ground, drones.get(i))).isEqualTo(level.pixels(ground, drones.get(i)));
                }
            }
        }
        assertThat(hits).isGreaterThan(1000);
    }

    /** The axes turned by another library's rotation, and every pixel's ray traced on its own. */
    @Test
    void anyRollAndShiftShowWhatEveryPixelsRayMeets() {
        long seed = 27_182;
        System.out.println("seed of the cameras: " + seed);
        Random random = new Random(seed);
        int seen = 0;
        for (int i = 0; i < 30; i++) {
            double roll = random.nextDouble(-2 * Math.PI, 2 * Math.PI);
            Projection shift = i % 2 == 0
                    ? Projection.DEFAULT
                    : Projection.shifted(random.nextDouble(-0.6, 0.6), random.nextDouble(-0.6, 0.6));
            CameraSettings settings = LEVEL.withResolution(80, 60)
                    .withLookAt(LEVEL.position().plus(new Position(0, 6, 0)).plus(unit(random)))
                    .withRoll(roll)
                    .withProjection(shift);
            CameraSensor camera = settings.create();
            checkRays(settings, camera.camera());
            List<Drone> drones = drones(random);
            FullRetrace expected = new FullRetrace(camera.camera(), ground, drones);
            DepthImage image = camera.depthImage(ground, drones);
            for (int pixel = 0; pixel < 80 * 60; pixel++) {
                assertThat(image.isHit(pixel % 80, pixel / 80)).isEqualTo(expected.isHit(pixel));
                assertThat(image.distance(pixel % 80, pixel / 80)).isEqualTo(expected.distance(pixel));
                seen += expected.isHit(pixel) ? 1 : 0;
            }
        }
        assertThat(seen).isGreaterThan(1000);
    }

    private static void checkRays(CameraSettings settings, CameraObject camera) {
        Vector3d forward = settings.aim().from(settings.position()).unit().toVector3d();
        Vector3d right = new Vector3d();
        right.cross(forward, new Vector3d(0, 0, 1));
        right.normalize();
        Vector3d up = new Vector3d();
        up.cross(right, forward);
        Matrix4d turn = new Matrix4d();
        turn.set(new AxisAngle4d(forward, settings.roll()));
        turn.transform(right);
        turn.transform(up);
        double f = settings.focalLength();
        for (int pixel = 0; pixel < 80 * 60; pixel += 7) {
            int column = pixel % 80;
            int row = pixel / 80;
            Vector3d expected = new Vector3d(forward);
            expected.scaleAdd((column + 0.5 - 40 + settings.projection().shiftRight() * 80) / f, right, expected);
            expected.scaleAdd((30 - row - 0.5 + settings.projection().shiftUp() * 60) / f, up, expected);
            expected.normalize();
            expected.sub(camera.ray(column, row).direction());
            assertThat(expected.length()).isLessThan(1e-14);
        }
    }

    @Test
    void pixelsRaysAndOutlineOfRolledAndShiftedCamerasAgree() {
        Random random = new Random(16_180);
        int inside = 0;
        for (int i = 0; i < 2000; i++) {
            CameraObject camera = new CameraObject(LEVEL.withResolution(80, 60)
                    .withLookAt(LEVEL.position().plus(unit(random)))
                    .withRoll(random.nextDouble(-7, 7))
                    .withProjection(Projection.shifted(random.nextDouble(-1, 1), random.nextDouble(-1, 1))));
            int column = random.nextInt(80);
            int row = random.nextInt(60);
            Point2d pixel = camera.pixelOf(camera.ray(column, row).pointAt(0.1 + 100 * random.nextDouble()))
                    .orElseThrow();
            assertThat(pixel.x).isCloseTo(column + 0.5, within(1e-6));
            assertThat(pixel.y).isCloseTo(row + 0.5, within(1e-6));

            Position vector = unit(random).times(20 * random.nextDouble());
            Position point = camera.position().plus(vector);
            boolean expected = camera.pixelOf(point.toPoint3d())
                    .filter(at -> at.x >= 0 && at.x <= 80 && at.y >= 0 && at.y <= 60)
                    .isPresent();
            assertThat(camera.outline().contains(vector)).isEqualTo(expected);
            inside += expected ? 1 : 0;
            if (expected) {
                assertThat(camera.isOutside(point.x(), point.y(), point.z(), 0.0))
                        .isFalse();
            }
            for (Position corner : camera.outline().corners(camera.position(), 30)) {
                Point2d at = camera.pixelOf(corner.toPoint3d()).orElseThrow();
                assertThat(Math.min(Math.abs(at.x), Math.abs(at.x - 80))).isCloseTo(0, within(1e-6));
                assertThat(Math.min(Math.abs(at.y), Math.abs(at.y - 60))).isCloseTo(0, within(1e-6));
            }
        }
        assertThat(inside).isGreaterThan(50);
    }

    /** The picture of an off-centre frustum is a rectangle cut out of a larger, symmetric one. */
    @Test
    void anOffCentreFrustumShowsARectangleOfALargerPicture() {
        Random random = new Random(14_142);
        Position at = LEVEL.position();
        Position to = new Position(0.1, 1, 0.05);
        double focal = 110;
        CameraObject large = new CameraObject(at, to, 0.3, 256, 128, focal, Projection.DEFAULT);
        for (int i = 0; i < 20; i++) {
            int left = random.nextInt(192);
            int top = random.nextInt(96);
            // The middles of the two pictures are apart by these fractions of 64 and 32 pixels.
            Projection shift = Projection.shifted((left + 32 - 128) / 64.0, (64 - top - 16) / 32.0);
            CameraObject part = new CameraObject(at, to, 0.3, 64, 32, focal, shift);
            List<Drone> drones = drones(random);
            DepthImage whole = new DronePicture(large).depthImage(ground, drones);
            DepthImage image = new DronePicture(part).depthImage(ground, drones);
            double[] expected = new double[3];
            double[] direction = new double[3];
            for (int row = 0; row < 32; row++) {
                for (int column = 0; column < 64; column++) {
                    large.direction(left + column, top + row, expected);
                    part.direction(column, row, direction);
                    assertThat(direction).isEqualTo(expected);
                    assertThat(image.isHit(column, row)).isEqualTo(whole.isHit(left + column, top + row));
                    assertThat(image.distance(column, row)).isEqualTo(whole.distance(left + column, top + row));
                }
            }
        }
    }

    /** Every pixel's ray traced on its own from the near plane to the far one, through the site and each drone. */
    @Test
    void nothingIsSeenBeforeTheNearPlaneAndBehindTheFarOne() {
        long seed = 24_494;
        System.out.println("seed of the planes: " + seed);
        Random random = new Random(seed);
        int seen = 0;
        int cut = 0;
        for (int i = 0; i < 40; i++) {
            double near = i % 3 == 0 ? 0.0 : random.nextDouble(4, 11);
            double far = i % 3 == 1 ? Projection.DEFAULT.far() : near + random.nextDouble(0.2, 6);
            CameraSettings settings = LEVEL.withResolution(80, 60)
                    .withLookAt(LEVEL.position().plus(new Position(0, 6, 0)).plus(unit(random)))
                    .withRoll(random.nextDouble(-3, 3))
                    .withProjection(new Projection(random.nextDouble(-0.3, 0.3), 0.1, near, far));
            CameraObject camera = new CameraObject(settings);
            List<Drone> drones = drones(random);
            DepthImage image = settings.create().depthImage(ground, drones);
            DepthImage unlimited = settings.withProjection(
                            Projection.shifted(settings.projection().shiftRight(), 0.1))
                    .create()
                    .depthImage(ground, drones);
            double end = i % 3 == 1 ? Double.POSITIVE_INFINITY : far;
            for (int row = 0; row < 60; row++) {
                for (int column = 0; column < 80; column++) {
                    Vector3d d = camera.ray(column, row).direction();
                    Position axis = camera.outline().forward();
                    double slant = 1 / (d.x * axis.x() + d.y * axis.y() + d.z * axis.z());
                    float expected =
                            closest(ground.tree(), camera.position().toPoint3d(), d, near * slant, end * slant);
                    boolean hit = false;
                    for (Drone drone : drones) {
                        Point3d origin = camera.position().toPoint3d();
                        Vector3d direction = new Vector3d(d);
                        drone.worldToModel().transform(origin);
                        drone.worldToModel().transform(direction);
                        float distance = closest(drone.tree(), origin, direction, near * slant, end * slant);
                        hit |= distance < expected;
                        expected = Math.min(expected, distance);
                    }
                    assertThat(image.isHit(column, row)).isEqualTo(hit);
                    if (expected < Float.POSITIVE_INFINITY) {
                        assertThat(image.distance(column, row)).isCloseTo(expected, within(1e-6f * expected));
                    } else {
                        assertThat(image.distance(column, row)).isEqualTo(expected);
                    }
                    seen += hit ? 1 : 0;
                    cut += unlimited.distance(column, row) != image.distance(column, row) ? 1 : 0;
                }
            }
        }
        assertThat(seen).isGreaterThan(1000);
        assertThat(cut).isGreaterThan(1000);
    }

    private static float closest(KDTree tree, Point3d origin, Vector3d direction, double from, double to) {
        return new StackTraversal(tree)
                .closestHit(new Ray(origin, direction, from, to))
                .map(hit -> (float) hit.distance())
                .orElse(Float.POSITIVE_INFINITY);
    }

    /** The ball is cut: what lies before the near plane is not seen, and what is behind it shows its inside. */
    @Test
    void theVisibleAreaIsThatBetweenThePlanes() {
        Position middle = LEVEL.position().plus(new Position(0, 10, 0));
        CameraSettings settings = LEVEL.withLookAt(middle).withVerticalFov(0.15).withResolution(300, 300);
        Drone drone = Shapes.drone("ball", ball, middle);
        for (double[] planes : new double[][] {{0, 1e6}, {10.3, 1e6}, {0, 9.7}, {9.9, 1e6}, {11, 1e6}, {0, 9}}) {
            CameraObject camera = new CameraObject(settings.withProjection(new Projection(0, 0, planes[0], planes[1])));
            DronePicture picture = new DronePicture(camera);
            picture.draw(ground, List.of(drone));
            double area = new VisibleArea(camera, ground).of(drone);
            assertThat(area)
                    .isCloseTo(picture.pixels(0), within(0.03 * Math.PI * Math.pow(0.05 * camera.focalLength(), 2)));
            if (planes[0] == 10.3) {
                // The cap behind the plane has a radius of sqrt(0.5^2 - 0.3^2) = 0.4 m there.
                double cap = Math.PI * Math.pow(0.4 / 10.3 * camera.focalLength(), 2);
                assertThat(area).isCloseTo(cap, within(0.03 * cap));
            }
        }
    }

    /** Left, right, bottom and top as in the matrix of glFrustum, in the reference pages of OpenGL 2.1. */
    @Test
    void aFrustumIsThatOfOpenGl() {
        double left = -0.2;
        double right = 0.6;
        double bottom = -0.5;
        double top = 0.1;
        double near = 0.9;
        double far = 70;
        CameraSettings settings = LEVEL.withResolution(80, 60).withFrustum(left, right, bottom, top, near, far);
        org.joml.Matrix4d projection = new CameraObject(settings).projection();
        assertThat(projection.m00()).isCloseTo(2 * near / (right - left), within(1e-12));
        assertThat(projection.m11()).isCloseTo(2 * near / (top - bottom), within(1e-12));
        assertThat(projection.m20()).isCloseTo((right + left) / (right - left), within(1e-12));
        assertThat(projection.m21()).isCloseTo((top + bottom) / (top - bottom), within(1e-12));
        assertThat(projection.m22()).isCloseTo(-(far + near) / (far - near), within(1e-12));
        assertThat(projection.m32()).isCloseTo(-2 * far * near / (far - near), within(1e-12));
        assertThatIllegalArgumentException()
                .isThrownBy(() -> LEVEL.withFrustum(-1, 1, -0.5, 0.5, 1, 2))
                .withMessageEndingWith("in an image of 96 x 96: pixels must be square");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> LEVEL.withFrustum(1, -1, -1, 1, 1, 2))
                .withMessageContaining("left must be less than right");
    }

    @Test
    void aVectorCanBeAtTheTopOfThePicture() {
        Random random = new Random(17_320);
        for (int i = 0; i < 100; i++) {
            Position up = unit(random).times(3);
            Outline.Frustum outline = new CameraObject(LEVEL.withUp(up)).outline();
            assertThat(up.dot(outline.right())).isCloseTo(0.0, within(1e-12));
            assertThat(up.dot(outline.up())).isPositive();
        }
        assertThat(LEVEL.withUp(new Position(0, 0, 1)).roll()).isCloseTo(0.0, within(1e-15));
        assertThatIllegalArgumentException()
                .isThrownBy(
                        () -> LEVEL.withUp(LEVEL.aim().from(LEVEL.position()).times(-2)))
                .withMessageContaining("must not point along the axis of the camera");
    }

    @Test
    void aPositionerKeepsRollAndShift() {
        CameraSettings settings = LEVEL.withRoll(0.4).withProjection(Projection.shifted(0.1, -0.2));
        CameraSettings pointed = settings.pointed(Pointing.still(new Direction(1.0, 0.2), 0.5, OptionalInt.empty()));
        assertThat(pointed.roll()).isEqualTo(0.4);
        assertThat(pointed.projection()).isEqualTo(settings.projection());
    }

    /** What thermal cameras measure of a drone at the edge of a rolled and shifted picture, against its pixels. */
    @Test
    void theVisibleAreaIsThatInsideThePicture() {
        Random random = new Random(22_360);
        int partly = 0;
        for (int i = 0; i < 40; i++) {
            CameraObject camera = new CameraObject(LEVEL.withResolution(400, 300)
                    .withVerticalFov(0.6)
                    .withRoll(random.nextDouble(-4, 4))
                    .withProjection(Projection.shifted(random.nextDouble(-0.5, 0.5), random.nextDouble(-0.5, 0.5))));
            Position place = camera.position()
                    .plus(LEVEL.aim().from(LEVEL.position()))
                    .plus(unit(random).times(2));
            Drone drone = Shapes.drone("ball", ball, place);
            DronePicture picture = new DronePicture(camera);
            picture.draw(ground, List.of(drone));
            int pixels = picture.pixels(0);
            int whole = (int) (Math.PI * Math.pow(0.5 * camera.focalLength() / 10, 2));
            assertThat(new VisibleArea(camera, ground).of(drone)).isCloseTo(pixels, within(0.05 * whole));
            partly += pixels > 0.1 * whole && pixels < 0.9 * whole ? 1 : 0;
        }
        assertThat(partly).isPositive();
    }

    @Test
    void rollAndShiftHaveLimits() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> LEVEL.withRoll(13))
                .withMessageContaining("roll");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Projection.shifted(6, 0))
                .withMessageContaining("shiftRight 6");
        assertThatIllegalArgumentException()
                .isThrownBy(() -> new Projection(0, 0, 20, 20))
                .withMessage("near 20.0 m must be less than far 20.0 m");
    }
}
