package org.dronewatch.examples;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import java.util.Random;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.Hit;
import org.dronewatch.geometry.IntersectionHandler;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.Ray;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.SequentialTraversal;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.sensor.acoustic.level.LevelModel;
import org.dronewatch.sensor.acoustic.level.ReflectionGenerator;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.optics.CameraObject;
import org.dronewatch.sensor.optics.DronePicture;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.surface.SurfaceMaterials;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;

/** The parts of a scene used one by one: rays and a tree, a drone that turns, a camera, sound that meets a wall. */
public final class ByHand {
    private ByHand() {}

    /** A wall of two triangles, 40 m to the north, 10 m wide and 6 m high. */
    static TriangleMesh wall() {
        float[] corners = {-5, 40, 0, 5, 40, 0, 5, 40, 6, -5, 40, 6};
        return TriangleMesh.of(corners, new int[] {0, 1, 2, 0, 2, 3});
    }

    /** How far a ray travels to the nearest triangle, found through a tree, m; empty if it meets none. */
    static OptionalDouble throughATree(Ray ray) {
        return new SequentialTraversal(KDTree.of(wall()))
                .closestHit(ray).stream().mapToDouble(Hit::distance).findFirst();
    }

    /** The same, found by trying every triangle. */
    static OptionalDouble triangleByTriangle(Ray ray) {
        TriangleMesh wall = wall();
        double nearest = Double.POSITIVE_INFINITY;
        for (int i = 0; i < wall.triangleCount(); i++) {
            nearest = Math.min(
                    nearest,
                    IntersectionHandler.rayTriangle(ray, wall.triangle(i))
                            .map(Hit::distance)
                            .orElse(nearest));
        }
        return Double.isInfinite(nearest) ? OptionalDouble.empty() : OptionalDouble.of(nearest);
    }

    /** The distances at which a ray enters and leaves a box, m; empty if the ray misses the box. */
    static List<Double> withinABox(Ray ray, AABB box) {
        double[] interval = new double[2];
        return IntersectionHandler.rayBox(ray, box, interval) ? List.of(interval[0], interval[1]) : List.of();
    }

    /**
     * The packaged quadrotor, 20 m to the north, after it has pitched for two seconds, that is, turned about the axis
     * that points to its right.
     */
    static Drone turnedDrone(double rate) {
        return DroneSettings.of(ModelSettings.packaged("quadrotor.obj"), Hover.at(new Position(0, 0, 0)))
                .create("quadrotor", Path.of(""))
                .rotateX(rate, 2.0)
                .move(new Vector3d(0, 20, 3));
    }

    /** A camera at eye level that looks north. */
    static CameraObject camera() {
        return new CameraObject(CameraSettings.at(new Position(0, 0, 1.6)).withLookAt(new Position(0, 20, 3)));
    }

    /** How many pixels show a drone in front of the wall. */
    static int pixels(Drone drone) {
        return new DronePicture(camera())
                .pixels(World.of(wall()), List.of(drone))
                .get(0)
                .count();
    }

    /**
     * The directions of the rays that leave the wall, if it is of concrete, when sound arrives at an angle from the
     * right: the reflected one, and the refracted one unless all is reflected.
     */
    static List<Vector3d> soundAtTheWall(double angle) {
        World world = new World(
                KDTree.of(wall()),
                BackgroundNoise.of(30.0),
                List.of(SurfaceMaterials.get("wall_concrete_200mm")),
                Atmosphere.STANDARD);
        AcousticRay ray = new AcousticRay();
        ray.originY = 39.0;
        ray.originZ = 2.0;
        ray.directionX = Math.sin(angle);
        ray.directionY = Math.cos(angle);
        ray.energy = 1.0;
        ray.level = 55.0;
        ray.medium = AcousticRay.AIR;
        List<Vector3d> directions = new ArrayList<>();
        new ReflectionGenerator(LevelModel.DEFAULT.withRays(1, 1), world, new Position(0, 0, 2))
                .acousticDistribution(
                        ray,
                        1.0 / Math.cos(angle),
                        0,
                        ray.level,
                        new Random(1),
                        branch ->
                                directions.add(new Vector3d(branch.directionX, branch.directionY, branch.directionZ)));
        return directions;
    }

    public static void main(String[] args) {
        Ray ray = new Ray(new Point3d(1, 0, 1.5), new Vector3d(0, 1, 0.05));
        System.out.println("through the tree, m: " + throughATree(ray));
        System.out.println("triangle by triangle, m: " + triangleByTriangle(ray));
        System.out.println("within the wall's box, m: " + withinABox(ray, wall().bounds()));
        System.out.println("to a sphere of 2 m, m: " + IntersectionHandler.raySphere(ray, new Point3d(0, 20, 2), 2.0));
        for (double rate : new double[] {0.0, 0.25}) {
            Drone drone = turnedDrone(rate);
            System.out.println("pitching at " + rate + " rad/s, pixels of the drone: " + pixels(drone));
            System.out.println("its matrix:\n" + drone.modelMatrix());
        }
        System.out.println("the camera's matrix:\n" + camera().view());
        for (double degrees : new double[] {5.0, 6.0}) {
            System.out.println("sound at " + degrees + " degrees leaves as " + soundAtTheWall(Math.toRadians(degrees)));
        }
    }
}
