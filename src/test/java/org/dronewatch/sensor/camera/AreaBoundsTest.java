package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.optics.AreaBounds;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Bounds on what a camera sees of a drone within a sphere, against the sphere's outline and rays to its surface. */
class AreaBoundsTest {
    private static final long SEED = 20261201;
    private static final Position PLACE = new Position(12, -7, 3);
    private static final CameraSettings CAMERA = CameraSettings.at(PLACE)
            .withLookAt(PLACE.plus(new Position(0, 100, 10)))
            .withResolution(640, 480)
            .withHorizontalFov(1.0);

    /** Random rectangles in front of the camera, some of which hide the sphere, alone or together. */
    @Test
    void noRayReachesADroneThatIsCertainlyHidden() {
        SplittableRandom random = new SplittableRandom(SEED);
        int hidden = 0;
        int inSight = 0;
        for (int site = 0; site < 60; site++) {
            World world = World.of(rectangles(random));
            AreaBounds bounds = new AreaBounds(new CameraObject(CAMERA), world);
            Visibility visibility = new Visibility(world);
            for (int i = 0; i < 20; i++) {
                Position at = PLACE.plus(new Position(
                        random.nextDouble(-25, 25), random.nextDouble(30, 110), random.nextDouble(-5, 20)));
                double radius = random.nextDouble(0.2, 2.5);
                boolean isInSight = isInSight(visibility, random, at, radius);
                boolean isHidden = bounds.isHidden(at, radius);
                assertThat(isHidden && isInSight)
                        .as("hidden, but in sight: site %d, place %d of seed %d", site, i, SEED)
                        .isFalse();
                hidden += isHidden ? 1 : 0;
                inSight += isInSight ? 1 : 0;
            }
        }
        assertThat(hidden).isGreaterThan(150);
        assertThat(inSight).isGreaterThan(300);
    }

    /** A large wall whose triangles meet elsewhere hides everything behind it, and nothing else. */
    @Test
    void aWallHidesWhatIsBehindIt() {
        TriangleMesh wall = Shapes.rectangle(
                PLACE.plus(new Position(-300, 50, -100)),
                PLACE.plus(new Position(100, 50, -100)),
                PLACE.plus(new Position(100, 50, 300)));
        AreaBounds bounds = new AreaBounds(new CameraObject(CAMERA), World.of(wall));
        for (double side : new double[] {-8, 0.5, 9}) {
            assertThat(bounds.isHidden(PLACE.plus(new Position(side, 53, 4)), 2))
                    .isTrue();
            assertThat(bounds.isHidden(PLACE.plus(new Position(side, 51.5, 4)), 2))
                    .as("through the wall")
                    .isFalse();
            assertThat(bounds.isHidden(PLACE.plus(new Position(side, 40, 4)), 2))
                    .isFalse();
        }
    }

    /** The outline of a sphere in the image plane is an ellipse. */
    @Test
    void theUpperBoundIsAboveTheAreaOfTheSphereAndNotFarAbove() {
        SplittableRandom random = new SplittableRandom(SEED);
        CameraObject camera = new CameraObject(CAMERA);
        AreaBounds bounds = new AreaBounds(camera, World.of(Shapes.ground(1, -1000)));
        Position forward = camera.outline().forward();
        for (int i = 0; i < 500; i++) {
            Position vector =
                    new Position(random.nextDouble(-40, 40), random.nextDouble(40, 200), random.nextDouble(-30, 40));
            double radius = random.nextDouble(0.1, 3);
            double sine = radius / vector.length();
            double cosine = vector.unit().dot(forward);
            double focal = camera.focalLength();
            double area = Math.PI
                    * Math.pow(focal * sine, 2)
                    * Math.sqrt(1 - sine * sine)
                    / Math.pow(cosine * cosine - sine * sine, 1.5);
            double most = bounds.most(PLACE.plus(vector), radius);
            assertThat(most)
                    .as("%s, radius %s", vector, radius)
                    .isBetween(area, 1.4 * area / Math.pow(1 - 2 * sine, 3));
        }
        assertThat(bounds.most(PLACE.plus(new Position(0, -100, 0)), 1))
                .as("behind")
                .isEqualTo(Double.MAX_VALUE);
        assertThat(bounds.most(PLACE.plus(new Position(0, 3, 0)), 1))
                .as("close")
                .isEqualTo(Double.MAX_VALUE);
        assertThat(bounds.most(PLACE, 1)).as("around the camera").isEqualTo(Double.MAX_VALUE);
        assertThat(bounds.isHidden(PLACE.plus(new Position(0, 12, 0)), 2))
                .as("close")
                .isFalse();
        assertThat(bounds.isHidden(PLACE, 1)).as("around the camera").isFalse();
    }

    private static TriangleMesh rectangles(SplittableRandom random) {
        List<TriangleMesh> all = new ArrayList<>();
        for (int i = 0; i < 12; i++) {
            Position corner = PLACE.plus(
                    new Position(random.nextDouble(-25, 20), random.nextDouble(10, 70), random.nextDouble(-6, 12)));
            double size = random.nextDouble(1, 14);
            Position right = new Position(size, random.nextDouble(-0.3, 0.3) * size, 0);
            Position up = new Position(0, random.nextDouble(-0.3, 0.3) * size, random.nextDouble(0.5, 1.5) * size);
            all.add(Shapes.rectangle(corner, corner.plus(right), corner.plus(up)));
        }
        return World.merge(all);
    }

    /** Whether any of many rays to the sphere gets there. */
    private static boolean isInSight(Visibility visibility, SplittableRandom random, Position at, double radius) {
        for (int i = 0; i < 300; i++) {
            Position direction =
                    new Position(random.nextDouble(-1, 1), random.nextDouble(-1, 1), random.nextDouble(-1, 1));
            Position point = at.plus(direction.unit().times(radius));
            if (visibility.isFree(PLACE, point)) {
                return true;
            }
        }
        return false;
    }
}
