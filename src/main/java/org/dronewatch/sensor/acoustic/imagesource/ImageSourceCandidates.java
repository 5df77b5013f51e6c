package org.dronewatch.sensor.acoustic.imagesource;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;

/**
 * Candidates for image sources, each with its worth: a measure of the energy that the image source contributes, in
 * arbitrary units.
 */
public final class ImageSourceCandidates {
    private static final int FIRST_SIZE = 64;
    private static final long FREE = -1L;

    private int[] parents = new int[FIRST_SIZE];
    private int[] walls = new int[FIRST_SIZE];
    private double[] worths = new double[FIRST_SIZE];
    private int count = 1;

    /** The images by parent and wall, in a hash table with open addressing. */
    private long[] keys = new long[2 * FIRST_SIZE];

    private int[] children = new int[2 * FIRST_SIZE];

    /** Candidates that consist only of the source itself. */
    public ImageSourceCandidates() {
        parents[ImageSources.ORIGINAL] = ImageSources.ORIGINAL;
        walls[ImageSources.ORIGINAL] = WallPlanes.NONE;
        worths[ImageSources.ORIGINAL] = Double.POSITIVE_INFINITY;
        Arrays.fill(keys, FREE);
    }

    /**
     * Adds an image source unless it is already known, and increases its worth.
     *
     * @param parent index of the image source that is mirrored in the wall
     * @param wall the last wall of the image source
     * @param worth amount by which the worth increases
     * @return index of the image source
     */
    public int add(int parent, int wall, double worth) {
        long key = key(parent, wall);
        int slot = slot(key);
        if (keys[slot] == FREE) {
            if (count == parents.length) {
                grow();
                slot = slot(key);
            }
            parents[count] = parent;
            walls[count] = wall;
            keys[slot] = key;
            children[slot] = count;
            count++;
        }
        int image = children[slot];
        worths[image] += worth;
        return image;
    }

    private static long key(int parent, int wall) {
        return ((long) parent << Integer.SIZE) + wall;
    }

    /** The slot that holds a key, or the free slot in which the key would be put. */
    private int slot(long key) {
        int mask = keys.length - 1;
        long mixed = key * 0x9E3779B97F4A7C15L;
        int slot = (int) (mixed >>> Integer.SIZE) & mask;
        while (keys[slot] != key && keys[slot] != FREE) {
            slot = slot + 1 & mask;
        }
        return slot;
    }

    private void grow() {
        parents = Arrays.copyOf(parents, 2 * count);
        walls = Arrays.copyOf(walls, 2 * count);
        worths = Arrays.copyOf(worths, 2 * count);
        keys = new long[4 * count];
        children = new int[4 * count];
        Arrays.fill(keys, FREE);
        for (int image = 1; image < count; image++) {
            int slot = slot(key(parents[image], walls[image]));
            keys[slot] = key(parents[image], walls[image]);
            children[slot] = image;
        }
    }

    /** Adds the image source of a sequence of walls, in order from the first, and all its parents. */
    public void add(int[] sequence, double worth) {
        int image = ImageSources.ORIGINAL;
        for (int wall : sequence) {
            image = add(image, wall, worth);
        }
    }

    /** Whether no image source has been added. */
    public boolean isEmpty() {
        return count == 1;
    }

    /** Adds, with a worth of 0, those image sources of another set that are not known yet. */
    public void add(ImageSources others) {
        int[] images = new int[others.count()];
        for (int image = 1; image < images.length; image++) {
            images[image] = add(images[others.parent(image)], others.wall(image), 0.0);
        }
    }

    /** The worth of the image source of a sequence of walls; 0 if the image source is not known. */
    public double worth(int[] sequence) {
        int image = ImageSources.ORIGINAL;
        for (int wall : sequence) {
            int slot = slot(key(image, wall));
            if (keys[slot] == FREE) {
                return 0.0;
            }
            image = children[slot];
        }
        return worths[image];
    }

    /**
     * The walls of at most {@code most} first-order image sources: those with the greatest worth, in descending order
     * of worth.
     */
    public int[] firstWalls(int most) {
        return IntStream.range(1, count)
                .filter(image -> parents[image] == ImageSources.ORIGINAL)
                .boxed()
                .sorted(Comparator.comparingDouble((Integer image) -> -worths[image])
                        .thenComparingInt(image -> image))
                .limit(most)
                .mapToInt(image -> walls[image])
                .toArray();
    }

    /** The worth of an image source. */
    public double worth(int image) {
        return worths[image];
    }

    /**
     * The image sources with the greatest worth. No image source may be worth more than its parent.
     *
     * @param most maximum number
     * @param least minimum worth: image sources worth less than this are left out
     */
    public ImageSources best(int most, double least) {
        int[] kept = IntStream.range(0, count)
                .filter(image -> worths[image] >= least)
                .toArray();
        if (kept.length > most) {
            kept = mostWorthy(kept, most);
        }
        int[] numbers = new int[count];
        int[] itsParents = new int[kept.length];
        int[] itsWalls = new int[kept.length];
        for (int i = 0; i < kept.length; i++) {
            numbers[kept[i]] = i;
            itsParents[i] = numbers[parents[kept[i]]];
            itsWalls[i] = walls[kept[i]];
        }
        return new ImageSources(itsParents, itsWalls);
    }

    /**
     * The images with the greatest worth, if there are more than can be kept; of images with equal worth, those that
     * were added first.
     */
    private int[] mostWorthy(int[] images, int most) {
        double[] sorted = Arrays.stream(images)
                .mapToDouble(image -> worths[image])
                .sorted()
                .toArray();
        double last = sorted[sorted.length - most];
        int asGood = most;
        for (int place = sorted.length - 1; place >= 0 && sorted[place] > last; place--) {
            asGood--;
        }
        int[] kept = new int[most];
        int next = 0;
        for (int image : images) {
            if (worths[image] > last || worths[image] == last && asGood-- > 0) {
                kept[next++] = image;
            }
        }
        return kept;
    }
}
