package org.dronewatch.sensor.camera;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Sample;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.world.Drone;
import org.dronewatch.world.World;
import org.jogamp.vecmath.Vector3d;

/**
 * A camera for visible light. Keeps the static view of the world it saw last, and scratch memory for the drones before
 * it: one thread at a time.
 */
public final class CameraSensor implements Sensor {
    private final CameraSettings settings;
    private final CameraObject camera;

    private DynamicView dynamicView;
    private StaticView staticView;

    /** The way to the sun as long as the camera sees it. */
    private Vector3d sun;

    /** A camera of some settings. */
    public CameraSensor(CameraSettings settings) {
        this.settings = settings;
        this.camera = new CameraObject(settings);
    }

    /** Counts the pixels of each drone that is nearer than the world and the other drones. */
    @Override
    public List<Observation> observe(World world, List<Drone> drones, Sample sample) {
        draw(world, drones);
        List<Observation> observations = new ArrayList<>(drones.size());
        for (int i = 0; i < drones.size(); i++) {
            double range = drones.get(i).distance(settings.position());
            DroneView view = view(world, drones.get(i), dynamicView.pixels(i), range);
            observations.add(new Observation(
                    sample.sensor(),
                    settings.kind(),
                    drones.get(i).id(),
                    sample.index(),
                    sample.time(),
                    range,
                    settings.detection().value(view),
                    settings.detection().threshold(sample.random()),
                    settings.detection().unit()));
        }
        return observations;
    }

    private DroneView view(World world, Drone drone, int pixels, double range) {
        if (pixels == 0) {
            return new DroneView(0, range, camera.focalLength(), 0.0, world.light(), Double.POSITIVE_INFINITY);
        }
        Vector3d way = new Vector3d(drone.position());
        way.sub(settings.position().toPoint3d());
        way.normalize();
        // Its velocity but for what it comes nearer, as an angle a second, in pixels.
        Vector3d across = drone.velocity();
        across.scaleAdd(-across.dot(way), way, across);
        double crossing = across.length() / range * camera.focalLength();
        double sunAngle = sun == null ? Double.POSITIVE_INFINITY : way.angle(sun);
        return new DroneView(pixels, range, camera.focalLength(), crossing, world.light(), sunAngle);
    }

    /** The way to the sun, when the camera sees it, in its picture or not: null otherwise. */
    private Vector3d wayToSun(World world) {
        if (world.light().sun().isEmpty()) {
            return null;
        }
        Vector3d way = world.light().sun().get().direction().toVector3d();
        Position at = settings.position();
        boolean shaded = world.newTraversal()
                .isOccluded(at.x(), at.y(), at.z(), way.x, way.y, way.z, 0.0, Double.POSITIVE_INFINITY);
        return way.z < 0.0 || shaded ? null : way;
    }

    /**
     * The whole picture, traced on the threads of the {@link org.dronewatch.parallel.Workers} that call; the same for any
     * number of them.
     */
    public DepthImage depthImage(World world, List<Drone> drones) {
        draw(world, drones);
        float[] distances = staticView.all();
        boolean[] hits = new boolean[distances.length];
        dynamicView.overlay(distances, hits);
        return DepthImage.over(camera, distances, hits);
    }

    /** The significant pixels of each drone, in the same order, and which of them show it. */
    public List<DronePixels> pixels(World world, List<Drone> drones) {
        draw(world, drones);
        List<DronePixels> pixels = new ArrayList<>(drones.size());
        for (int i = 0; i < drones.size(); i++) {
            pixels.add(dynamicView.pixels(i, drones.get(i).id()));
        }
        return pixels;
    }

    /** How many pixels show a drone when it is the only one. */
    public int pixels(World world, Drone drone) {
        draw(world, List.of(drone));
        return dynamicView.pixels(0);
    }

    private void draw(World world, List<Drone> drones) {
        if (staticView == null || !staticView.shows(world)) {
            staticView = new StaticView(camera, world);
            sun = wayToSun(world);
        }
        if (dynamicView == null) {
            dynamicView = new DynamicView(camera);
        }
        dynamicView.draw(staticView, drones);
    }

    /** Pose and projection. */
    public CameraObject camera() {
        return camera;
    }

    /** What this camera was made from. */
    public CameraSettings settings() {
        return settings;
    }
}
