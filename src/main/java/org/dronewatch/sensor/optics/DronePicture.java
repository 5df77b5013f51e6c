package org.dronewatch.sensor.optics;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.silhouette.SilhouetteTable;
import org.dronewatch.geometry.Position;
import org.dronewatch.kdtree.SightCone;
import org.dronewatch.raster.TileTracer;
import org.dronewatch.world.World;

/**
 * The pictures that a camera at rest takes of drones in a world. Caches the image of the most recent world, without its
 * drones, and keeps scratch memory for the drones: for use by one thread at a time.
 */
public final class DronePicture {
    /**
     * A relative tolerance, greater than the rounding error of distances in an image, which are of single precision.
     */
    private static final double ROUNDING = 4e-6;

    private final CameraObject camera;

    private final SiteImages images;
    private final boolean isAtRest;

    /** The view that drew drones in the previous pose; null if there is none. */
    private DynamicView former;

    private World formerWorld;
    private DynamicView dynamicView;
    private StaticView staticView;

    /** A view for drones without the world. */
    private DynamicView openView;

    private PixelBounds bounds;
    private SilhouetteTable boundSilhouettes;
    private Position boundPlace;
    private boolean isBound;

    private SightCone sight;

    /** The pictures of a camera in a temporary pose. */
    public DronePicture(CameraObject camera) {
        this(camera, new SiteImages(camera, false), false);
    }

    private DronePicture(CameraObject camera, SiteImages images, boolean isAtRest) {
        this.camera = camera;
        this.images = images;
        this.isAtRest = isAtRest;
    }

    /**
     * The pictures of a camera whose pose is the same in several runs: if the worlds of these runs share a cache, the
     * image of the site is traced only once.
     */
    public static DronePicture atRest(CameraObject camera) {
        return new DronePicture(camera, new SiteImages(camera, true), true);
    }

    /** Pictures of the same camera, which share its image of the site, for use by another thread. */
    public DronePicture sibling() {
        return new DronePicture(camera, images, isAtRest);
    }

    /**
     * The pictures of a camera in another temporary pose, for the same thread. The returned object takes over this
     * one's scratch memory; this one must not be used afterwards.
     */
    public DronePicture turned(CameraObject to) {
        DronePicture turned = new DronePicture(to);
        if (staticView != null) {
            turned.former = dynamicView;
            turned.formerWorld = staticView.world();
        }
        return turned;
    }

    /** The pose and projection of the camera. */
    public CameraObject camera() {
        return camera;
    }

    /** Draws drones, which replace those drawn before. */
    public void draw(World world, List<Drone> drones) {
        setWorld(world);
        dynamicView.draw(staticView, drones);
    }

    /**
     * Draws a drone alone, which replaces those drawn before, until enough of its pixels have been found.
     *
     * @param enough whether a number of pixels is sufficient; if it is, every larger number must be as well
     */
    public void draw(World world, Drone drone, IntPredicate enough) {
        setWorld(world);
        dynamicView.draw(background(drone.origin(), drone.radius()), drone, enough);
    }

    /** An upper bound on the number of pixels that show a drone in a world. */
    public int mostPixels(World world, Drone drone) {
        setWorld(world);
        return dynamicView.mostPixels(drone);
    }

    /**
     * Bounds on the number of pixels that show a level drone at a position.
     *
     * @param silhouettes the silhouettes of the drone
     * @param at position of its origin, m
     * @return empty where none are known: close to the camera, and for a drone that is not entirely between the near
     *     and far planes
     */
    public Optional<PixelBounds> bounds(World world, SilhouetteTable silhouettes, Position at) {
        setWorld(world);
        if (isAtRest) {
            staticView.expectAll();
        }
        if (bounds == null) {
            bounds = new PixelBounds(camera);
        }
        if (silhouettes != boundSilhouettes || !at.equals(boundPlace)) {
            boundSilhouettes = silhouettes;
            boundPlace = at;
            isBound = bounds.set(background(at, silhouettes.radius()), silhouettes, at);
        }
        return isBound ? Optional.of(bounds) : Optional.empty();
    }

    /**
     * Whether it is certain that the site hides a level drone at a position, whatever its heading, or that the drone
     * lies between the rays of the pixels; false where no bounds are known. Parameters as for {@link #bounds}.
     */
    public boolean isInvisible(World world, SilhouetteTable silhouettes, Position at) {
        Optional<PixelBounds> found = bounds(world, silhouettes, at);
        return found.isPresent()
                && (isHidden(world, silhouettes.radius(), at) || found.get().isInvisible());
    }

    /**
     * Whether a few triangles certainly hide a drone from all pixels. A camera in a temporary pose need not trace the
     * site then.
     */
    private boolean isHidden(World world, double radius, Position at) {
        // A larger sphere makes up for distances of single precision in the image.
        return !isAtRest
                && new AreaBounds(camera, world).isHidden(at, radius + ROUNDING * at.distance(camera.position()));
    }

    /**
     * Traces pixels of a drone until the bounds suffice or are exact, at the heading of the most recent
     * {@link PixelBounds#count}.
     *
     * @param there the bounds, which are narrowed
     * @param enough the predicate passed to that count
     * @param isSufficient whether the bounds suffice as they are now
     * @return false where it is faster to draw a picture of the drone
     */
    public boolean refine(PixelBounds there, Drone drone, IntPredicate enough, BooleanSupplier isSufficient) {
        return there.refine(dynamicView, drone, enough, isSufficient);
    }

    /** The background of a drone: none for a camera in a temporary pose if nothing can be in front of the drone. */
    private Background background(Position at, double radius) {
        return !isAtRest && sight.isClear(at, radius) ? Background.NOTHING : staticView;
    }

    private void setWorld(World world) {
        if (staticView == null || !staticView.shows(world)) {
            change(world);
        }
    }

    private void change(World world) {
        boundPlace = null;
        sight = new SightCone(world.tree(), camera.position());
        staticView = new StaticView(camera, world, images);
        dynamicView = world == formerWorld ? former.turned(camera) : new DynamicView(camera, world::newTileTracer);
    }

    /** The number of pixels that show a drone, by its index in the list that was drawn. */
    public int pixels(int number) {
        return dynamicView.pixels(number);
    }

    /**
     * The number of pixels that would show a drone if it were alone and unobstructed; the drones drawn are kept.
     *
     * @param enough whether a number of pixels is sufficient; counting stops there
     */
    public int pixelsInTheOpen(Drone drone, IntPredicate enough) {
        if (openView == null) {
            openView = new DynamicView(camera, TileTracer::new);
        }
        openView.draw(Background.NOTHING, drone, enough);
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

    /** For each drone in the given order, its significant pixels, and which of these show the drone. */
    public List<DronePixels> pixels(World world, List<Drone> drones) {
        draw(world, drones);
        List<DronePixels> pixels = new ArrayList<>(drones.size());
        for (int i = 0; i < drones.size(); i++) {
            pixels.add(dynamicView.pixels(i, drones.get(i).id()));
        }
        return pixels;
    }
}
