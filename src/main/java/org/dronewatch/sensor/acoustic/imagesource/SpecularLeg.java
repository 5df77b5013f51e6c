package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.acoustic.propagation.AcousticRay;

/**
 * The leg of a ray since it left the sensor or the source or was last scattered: its sequence of specular reflections,
 * and whether this is the sequence of an image source. For use by one thread.
 */
public final class SpecularLeg {
    private int[] walls = new int[16];
    private long key;
    private long reverse;
    private long weight;
    private int order;
    private boolean isThroughWalls;
    private double length;
    private double fromX;
    private double fromY;
    private double fromZ;
    private double riseFromBeginning;

    /** The last two trees of image sources that the leg has left, with walls in order from the leg's beginning on. */
    private ImageSources left;

    private ImageSources leftBefore;

    /** Begins a leg at a ray's origin. */
    public void begin(AcousticRay ray) {
        fromX = ray.originX;
        fromY = ray.originY;
        fromZ = ray.originZ;
        riseFromBeginning = ray.directionZ;
        length = 0.0;
        key = 0L;
        reverse = 0L;
        weight = 1L;
        order = 0;
        isThroughWalls = false;
        left = null;
        leftBefore = null;
    }

    /** Takes over the reflections of another leg. */
    public void copy(SpecularLeg other) {
        if (walls.length < other.order) {
            walls = new int[other.walls.length];
        }
        System.arraycopy(other.walls, 0, walls, 0, other.order);
        key = other.key;
        reverse = other.reverse;
        weight = other.weight;
        order = other.order;
        isThroughWalls = other.isThroughWalls;
        length = other.length;
        fromX = other.fromX;
        fromY = other.fromY;
        fromZ = other.fromZ;
        riseFromBeginning = other.riseFromBeginning;
        left = other.left;
        leftBefore = other.leftBefore;
    }

    /** Records that the ray travelled a distance, m. */
    public void travel(double distance) {
        length += distance;
    }

    /** Records a reflection. */
    public void reflect(int wall) {
        key = ImageSources.appended(key, wall);
        reverse = ImageSources.prepended(reverse, wall, weight);
        weight = ImageSources.weightOfNext(weight);
        if (order == walls.length) {
            walls = Arrays.copyOf(walls, 2 * order);
        }
        walls[order] = wall;
        order++;
    }

    /** Records a wall through which the ray passed. */
    public void passThrough() {
        isThroughWalls = true;
    }

    /** Sine of the elevation at which the ray left the leg's beginning; negative downward. */
    public double riseFromBeginning() {
        return riseFromBeginning;
    }

    /** The distance that the ray has travelled, m. */
    public double length() {
        return length;
    }

    /** Number of reflections. */
    public int order() {
        return order;
    }

    /**
     * Whether a path via the same walls leads to a point, rather than past it. Not valid for a ray that has passed
     * through a wall.
     */
    public boolean leadsTo(Position point, SpecularPath path, WallPlanes planes) {
        ImageSources backward = backward();
        double[] images = new double[3 * backward.count()];
        backward.positions(point.x(), point.y(), point.z(), planes, images);
        return path.follow(backward, images, order, fromX, fromY, fromZ);
    }

    /** The walls in the order in which sound from the point where the ray ends would hit them. */
    private ImageSources backward() {
        int[] sequence = new int[order];
        for (int i = 0; i < order; i++) {
            sequence[i] = walls[order - 1 - i];
        }
        return ImageSources.of(sequence);
    }

    /** Whether the ray has passed through a wall. */
    public boolean isThroughWalls() {
        return isThroughWalls;
    }

    /** Whether the ray has travelled in a straight line, through air alone. */
    public boolean isStraight() {
        return order == 0 && !isThroughWalls;
    }

    /**
     * Whether the walls that reflected the ray are, in the same order, those of one of the image sources of the point
     * where the ray began, and the ray travelled through air alone.
     */
    public boolean matchesFromStart(ImageSources imageSources) {
        return !isThroughWalls && isReflectedFromStart(imageSources);
    }

    /**
     * Whether the walls that reflected the ray are, in the same order, those of one of the image sources of the point
     * where the ray began, whether or not it passed through other walls in between.
     */
    public boolean isReflectedFromStart(ImageSources imageSources) {
        // The parents of images are images, too: a leg that has left their tree never returns, and is not looked up.
        if (order == 0 || imageSources == left || imageSources == leftBefore) {
            return false;
        }
        if (imageSources.contains(order, key)) {
            return true;
        }
        leftBefore = left;
        left = imageSources;
        return false;
    }

    /**
     * Whether the walls that reflected the ray, traced backward, are, in the same order, those of one of the image
     * sources of a point where the ray ends, and the ray travelled through air alone.
     */
    public boolean matchesFromEnd(ImageSources imageSources) {
        return !isThroughWalls && isReflectedFromEnd(imageSources);
    }

    /**
     * Whether the walls that reflected the ray, traced backward, are, in the same order, those of one of the image
     * sources of a point where the ray ends, whether or not it passed through other walls in between.
     */
    public boolean isReflectedFromEnd(ImageSources imageSources) {
        return order > 0 && imageSources.contains(order, reverse);
    }
}
