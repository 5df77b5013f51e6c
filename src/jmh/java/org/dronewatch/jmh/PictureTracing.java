package org.dronewatch.jmh;

import java.util.concurrent.TimeUnit;
import org.dronewatch.bench.RollingTerrain;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.raster.TileTracer;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Time of a pixel of a picture: by tiles, and by the single rays that they replace. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Fork(1)
@Warmup(iterations = 3, time = 2)
@Measurement(iterations = 5, time = 2)
public class PictureTracing {
    private static final int WIDTH = 1024;
    private static final int HEIGHT = 768;
    private static final int GROUND = 2_000_000;

    /** The model to look at. */
    @Param({"hill", "cathedral", "house", "ground", "shuffled"})
    public String model;

    private TileTracer tiles;

    /** Puts a camera into the model. */
    @Setup
    public void load() {
        World world = World.of(mesh());
        AABB box = world.bounds();
        Point3d middle = box.center();
        // A church is looked at from within, the others from outside.
        double reach = model.equals("cathedral") ? 0.3 : 1.1;
        Position eye = new Position(
                middle.x - reach * (box.maxX() - middle.x),
                middle.y - reach * (box.maxY() - middle.y),
                model.equals("cathedral") ? middle.z : box.maxZ() + 10);
        CameraObject camera = new CameraObject(CameraSettings.at(eye)
                .withResolution(WIDTH, HEIGHT)
                .withAim(new Aim.Target(new Position(middle.x, middle.y, middle.z))));
        tiles = new TileTracer(world.tree());
        double[] corner = direction(camera, 0, 0);
        double[] right = difference(direction(camera, 1, 0), corner);
        double[] down = difference(direction(camera, 0, 1), corner);
        tiles.setPicture(new double[] {eye.x(), eye.y(), eye.z()}, corner, right, down);
    }

    private TriangleMesh mesh() {
        return switch (model) {
            case "ground" -> RollingTerrain.of(GROUND);
            case "shuffled" -> Bench.shuffled(RollingTerrain.of(GROUND));
            default -> Bench.worldMesh(model);
        };
    }

    /** A pixel's direction with a step of one unit along the camera's axis. */
    private static double[] direction(CameraObject camera, int column, int row) {
        Vector3d direction = camera.ray(column, row).direction();
        Vector3d axis = camera.ray(WIDTH / 2, HEIGHT / 2).direction();
        axis.add(camera.ray(WIDTH / 2 - 1, HEIGHT / 2 - 1).direction());
        axis.normalize();
        direction.scale(1.0 / direction.dot(axis));
        return new double[] {direction.x, direction.y, direction.z};
    }

    private static double[] difference(double[] a, double[] b) {
        return new double[] {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    }

    /** The whole picture, tile by tile. */
    @Benchmark
    @OperationsPerInvocation(WIDTH * HEIGHT)
    public double byTiles() {
        double sum = 0.0;
        for (int top = 0; top < HEIGHT; top += TileTracer.HEIGHT) {
            for (int left = 0; left < WIDTH; left += TileTracer.WIDTH) {
                tiles.trace(left, top, TileTracer.WIDTH, TileTracer.HEIGHT);
                sum += tiles.parameter(0, 0);
            }
        }
        return sum;
    }

    /**
     * The same without vector instructions: with them, the ground of two million triangles is painted; the other models
     * are not.
     */
    @Benchmark
    @Fork(
            value = 1,
            jvmArgs = {"-Xmx3g"})
    @OperationsPerInvocation(WIDTH * HEIGHT)
    public double byTilesWithoutVectors() {
        return byTiles();
    }

    /** The whole picture, ray by ray. */
    @Benchmark
    @OperationsPerInvocation(WIDTH * HEIGHT)
    public double byRays() {
        double sum = 0.0;
        for (int top = 0; top < HEIGHT; top += TileTracer.HEIGHT) {
            for (int left = 0; left < WIDTH; left += TileTracer.WIDTH) {
                tiles.traceSingly(left, top, TileTracer.WIDTH, TileTracer.HEIGHT);
                sum += tiles.parameter(0, 0);
            }
        }
        return sum;
    }
}
