package org.dronewatch.sensor.camera;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.Callable;
import javax.imageio.ImageIO;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.Workers;
import org.dronewatch.sensor.optics.*;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.junit.jupiter.api.Test;

/** Pictures against closed forms: a plane, a box and a sphere in one scene. */
class DepthImageTest {
    private static final int WIDTH = 320;
    private static final int HEIGHT = 200;
    private static final Position BOX_LOW = new Position(-6, 12, 0);
    private static final Position BOX_HIGH = new Position(-2, 15, 5);
    private static final Position SPHERE_CENTRE = new Position(4, 14, 3);
    private static final double RADIUS = 2.5;
    private static final int CUTS = 6;

    private final CameraSensor camera = CameraSettings.at(new Position(0.3, 0, 2))
            .withLookAt(new Position(0, 10, 2.2))
            .withResolution(WIDTH, HEIGHT)
            .withVerticalFov(1.0)
            .create();

    private static World world() {
        TriangleMesh sphere = Shapes.sphere(RADIUS, CUTS);
        float[] vertices = new float[3 * sphere.vertexCount()];
        double[] centre = {SPHERE_CENTRE.x(), SPHERE_CENTRE.y(), SPHERE_CENTRE.z()};
        for (int i = 0; i < vertices.length; i++) {
            vertices[i] = (float) (sphere.vertexCoordinate(i / 3, i % 3) + centre[i % 3]);
        }
        int[] corners = new int[3 * sphere.triangleCount()];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = sphere.vertexIndex(i / 3, i % 3);
        }
        return World.of(World.merge(
                List.of(Shapes.ground(2000, 0), Shapes.box(BOX_LOW, BOX_HIGH), TriangleMesh.of(vertices, corners))));
    }

    private static double plane(Point3d from, Vector3d way) {
        double t = -from.z / way.z;
        boolean inside = Math.abs(from.x + t * way.x) <= 1000 && Math.abs(from.y + t * way.y) <= 1000;
        return t > 0 && inside ? t : Double.POSITIVE_INFINITY;
    }

    private static double box(Point3d from, Vector3d way) {
        double[] origin = {from.x, from.y, from.z};
        double[] direction = {way.x, way.y, way.z};
        double[] low = {BOX_LOW.x(), BOX_LOW.y(), BOX_LOW.z()};
        double[] high = {BOX_HIGH.x(), BOX_HIGH.y(), BOX_HIGH.z()};
        double enter = 0.0;
        double leave = Double.POSITIVE_INFINITY;
        for (int axis = 0; axis < 3; axis++) {
            double a = (low[axis] - origin[axis]) / direction[axis];
            double b = (high[axis] - origin[axis]) / direction[axis];
            enter = Math.max(enter, Math.min(a, b));
            leave = Math.min(leave, Math.max(a, b));
        }
        return enter <= leave ? enter : Double.POSITIVE_INFINITY;
    }

    private static double sphere(Point3d from, Vector3d way, double radius) {
        Vector3d offset = new Vector3d(from);
        offset.sub(SPHERE_CENTRE.toPoint3d());
        double b = offset.dot(way);
        double discriminant = b * b - offset.lengthSquared() + radius * radius;
        return discriminant >= 0 ? -b - Math.sqrt(discriminant) : Double.POSITIVE_INFINITY;
    }

    private static double inscribedRadius(TriangleMesh sphere) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < sphere.triangleCount(); i++) {
            Vector3d a = sphere.triangle(i).a().toVector3d();
            Vector3d ab = sphere.triangle(i).b().toVector3d();
            Vector3d ac = sphere.triangle(i).c().toVector3d();
            ab.sub(a);
            ac.sub(a);
            Vector3d normal = new Vector3d();
            normal.cross(ab, ac);
            least = Math.min(least, Math.abs(normal.dot(a)) / normal.length());
        }
        return least;
    }

    /**
     * Plane and box are exact but for the rounding of corners to floats. The sphere's mesh lies between the sphere
     * through its corners and the one that touches its faces from inside, so its distances lie between those of the
     * two, and a ray between both silhouettes may hit or miss.
     */
    @Test
    void everyPixelShowsTheAnalyticDistance() {
        DepthImage image = withThreads(2, () -> camera.depthImage(world(), List.of()));
        double inner = inscribedRadius(Shapes.sphere(RADIUS, CUTS));
        int[] shown = new int[3];
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            var ray = camera.camera().ray(pixel % WIDTH, pixel / WIDTH);
            double others = Math.min(plane(ray.origin(), ray.direction()), box(ray.origin(), ray.direction()));
            double nearest = Math.min(others, sphere(ray.origin(), ray.direction(), RADIUS));
            double farthest = Math.min(others, sphere(ray.origin(), ray.direction(), inner));
            float distance = image.distance(pixel % WIDTH, pixel / WIDTH);
            if (farthest == Double.POSITIVE_INFINITY && distance == Float.POSITIVE_INFINITY) {
                shown[0]++;
                continue;
            }
            assertThat((double) distance)
                    .as("pixel %d, %d", pixel % WIDTH, pixel / WIDTH)
                    .isBetween(nearest * (1 - 1e-6), farthest * (1 + 1e-6));
            shown[nearest < others ? 2 : 1]++;
        }
        assertThat(shown[0]).as("sky").isGreaterThan(5000);
        assertThat(shown[1]).as("plane and box").isGreaterThan(5000);
        assertThat(shown[2]).as("sphere").isGreaterThan(2000);
    }

    @Test
    void anyNumberOfThreadsGivesTheSamePicture() throws IOException {
        World world = world();
        byte[] one = pfm(camera.settings().create().depthImage(world, List.of()));
        byte[] four = pfm(withThreads(4, () -> camera.settings().create().depthImage(world, List.of())));

        assertThat(four).isEqualTo(one);
    }

    @Test
    void aFloatMapHoldsTheDistancesFromBottomToTop() throws IOException {
        float sky = Float.POSITIVE_INFINITY;
        DepthImage image = new DepthImage(2, 3, new float[] {1, 2, 3, sky, 5, 6}, new boolean[6]);
        byte[] bytes = pfm(image);
        String header = "Pf\n2 3\n-1.0\n";

        assertThat(new String(bytes, 0, header.length(), StandardCharsets.US_ASCII))
                .isEqualTo(header);
        ByteBuffer floats = ByteBuffer.wrap(bytes, header.length(), bytes.length - header.length())
                .order(ByteOrder.LITTLE_ENDIAN);
        for (float expected : new float[] {5, 6, 3, sky, 1, 2}) {
            assertThat(floats.getFloat()).isEqualTo(expected);
        }
        assertThat(floats.hasRemaining()).isFalse();
    }

    @Test
    void aPictureIsDarkerWhereNearerAndMarksTheDroneAndTheSky() throws IOException {
        Drone drone = Shapes.drone("ball", Shapes.sphere(0.5, 3), new Position(0, 5, 4));
        DepthImage image = camera.depthImage(world(), List.of(drone));
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        image.writePng(stream);
        BufferedImage picture = ImageIO.read(new ByteArrayInputStream(stream.toByteArray()));

        assertThat(picture.getWidth()).isEqualTo(WIDTH);
        assertThat(picture.getHeight()).isEqualTo(HEIGHT);
        int orange = 0;
        for (int pixel = 0; pixel < WIDTH * HEIGHT; pixel++) {
            int column = pixel % WIDTH;
            int row = pixel / WIDTH;
            int rgb = picture.getRGB(column, row) & 0xffffff;
            boolean isOrange = (rgb >> 16) > 200 && (rgb & 0xff) < 100;
            assertThat(isOrange).isEqualTo(image.isHit(column, row));
            orange += isOrange ? 1 : 0;
            boolean isSky = Float.isInfinite(image.distance(column, row));
            boolean isBlue = (rgb & 0xff) > (rgb >> 16);
            assertThat(isBlue).isEqualTo(!isSky && !isOrange);
        }
        assertThat(orange).isEqualTo(image.hitCount()).isGreaterThan(100);
        int near = picture.getRGB(WIDTH / 2, HEIGHT - 1) & 0xff;
        int far = picture.getRGB(WIDTH / 2, HEIGHT / 2 + 8) & 0xff;
        assertThat(near).isLessThan(far);
    }

    private static byte[] pfm(DepthImage image) throws IOException {
        ByteArrayOutputStream stream = new ByteArrayOutputStream();
        image.writePfm(stream);
        assertThat(stream.size()).isPositive();
        return stream.toByteArray();
    }

    @Test
    void theDroneIsAsFarAsItIs() {
        Drone drone = Shapes.drone("box", Shapes.box(new Position(-1, -1, -1), new Position(1, 1, 1)), SPHERE_CENTRE);
        DepthImage image = camera.depthImage(World.of(Shapes.ground(10, -50)), List.of(drone));
        var pixel = camera.camera().pixelOf(SPHERE_CENTRE.toPoint3d()).orElseThrow();

        // The box's southern face is 13 m north of the camera; the ray goes there aslant.
        var ray = camera.camera().ray((int) pixel.x, (int) pixel.y);
        assertThat((double) image.distance((int) pixel.x, (int) pixel.y))
                .isCloseTo(13.0 / ray.direction().y, within(1e-5));
    }

    private static DepthImage withThreads(int number, Callable<DepthImage> picture) {
        try (Workers workers = new Workers(number)) {
            return workers.call(picture);
        }
    }
}
