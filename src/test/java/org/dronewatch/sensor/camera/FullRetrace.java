package org.dronewatch.sensor.camera;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Ray;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;
import org.dronewatch.sensor.optics.*;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Matrix4d;
import org.jogamp.vecmath.Point3d;
import org.jogamp.vecmath.Vector3d;

/** The plain way to a camera's picture: every pixel's ray against the world and every drone, nothing remembered. */
final class FullRetrace {
    private final int[] pixels;
    private final int[] owners;
    private final float[] distances;

    FullRetrace(CameraObject camera, World world, List<Drone> drones) {
        this.pixels = new int[drones.size()];
        this.owners = new int[camera.width() * camera.height()];
        this.distances = new float[owners.length];
        RayTracer ground = world.newRayTracer();
        List<RayTracer> trees = drones.stream()
                .<RayTracer>map(drone -> new StackTraversal(drone.tree()))
                .toList();
        for (int row = 0; row < camera.height(); row++) {
            for (int column = 0; column < camera.width(); column++) {
                int pixel = row * camera.width() + column;
                Ray ray = camera.ray(column, row);
                owners[pixel] = -1;
                distances[pixel] = distance(ground, ray.origin(), ray.direction());
                for (int i = 0; i < drones.size(); i++) {
                    Matrix4d toModel = drones.get(i).worldToModel();
                    Point3d origin = ray.origin();
                    Vector3d direction = ray.direction();
                    toModel.transform(origin);
                    toModel.transform(direction);
                    float distance = distance(trees.get(i), origin, direction);
                    if (distance < distances[pixel]) {
                        distances[pixel] = distance;
                        owners[pixel] = i;
                    }
                }
                if (owners[pixel] >= 0) {
                    pixels[owners[pixel]]++;
                }
            }
        }
    }

    private static float distance(RayTracer tree, Point3d origin, Vector3d direction) {
        return tree.closestHit(new Ray(origin, direction))
                .map(hit -> (float) hit.distance())
                .orElse(Float.POSITIVE_INFINITY);
    }

    int pixels(int drone) {
        return pixels[drone];
    }

    boolean isHit(int pixel) {
        return owners[pixel] >= 0;
    }

    float distance(int pixel) {
        return distances[pixel];
    }
}
