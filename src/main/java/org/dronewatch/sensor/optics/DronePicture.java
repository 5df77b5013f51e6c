package org.dronewatch.sensor.optics;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.raster.TileTracer;
import org.dronewatch.world.World;

/**
 * What a camera that stands still sees of a world and of the drones in it. Keeps the static view of the world it saw
 * last, and scratch memory for the drones before it: one thread at a time.
 */
public final class DronePicture {
    private final CameraObject camera;

    private DynamicView dynamicView;
    private StaticView staticView;

    /** For drones without the world. */
    private DynamicView openView;

    /** The picture of a camera. */
    public DronePicture(CameraObject camera) {
        this.camera = camera;
    }

    /** Pose and projection. */
    public CameraObject camera() {
        return camera;
    }

    /** Looks at drones; forgets those it saw before. */
    public void draw(World world, List<Drone> drones) {
        if (staticView == null || !staticView.shows(world)) {
            staticView = new StaticView(camera, world);
            dynamicView = new DynamicView(camera, world::newTileTracer);
        }
        dynamicView.draw(staticView, drones);
    }

    /** How many pixels show a drone, by its index in the list that was drawn. */
    public int pixels(int number) {
        return dynamicView.pixels(number);
    }

    /** How many pixels would show a drone if it were alone and nothing obstructed it; keeps what was drawn. */
    public int pixelsInTheOpen(Drone drone) {
        if (openView == null) {
            openView = new DynamicView(camera, TileTracer::new);
        }
        openView.draw(Background.NOTHING, List.of(drone));
        return openView.pixels(0);
    }

    /** The whole image with its drones: a distance for each pixel, and whether it shows a drone. */
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
}
