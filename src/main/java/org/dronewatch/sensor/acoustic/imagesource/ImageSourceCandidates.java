package org.dronewatch.sensor.acoustic.imagesource;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/**
 * Candidates for image sources, each with its worth: a measure of the energy that it contributes, in arbitrary units.
 */
public final class ImageSourceCandidates {
    private final List<Integer> parents = new ArrayList<>(List.of(ImageSources.ORIGINAL));
    private final List<Integer> walls = new ArrayList<>(List.of(WallPlanes.NONE));
    private final List<Double> worths = new ArrayList<>(List.of(Double.POSITIVE_INFINITY));
    private final Map<Long, Integer> children = new HashMap<>();

    /**
     * Adds an image source unless it is already known, and adds to its worth.
     *
     * @return its index
     */
    public int add(int parent, int wall, double worth) {
        int image = children.computeIfAbsent(((long) parent << Integer.SIZE) + wall, key -> {
            parents.add(parent);
            walls.add(wall);
            worths.add(0.0);
            return parents.size() - 1;
        });
        worths.set(image, worths.get(image) + worth);
        return image;
    }

    /** Adds the image source of a sequence of walls, in order from the first, and all its parents. */
    public void add(int[] sequence, double worth) {
        int image = ImageSources.ORIGINAL;
        for (int wall : sequence) {
            image = add(image, wall, worth);
        }
    }

    /** The worth of the image source of a sequence of walls; 0 if the image source is not known. */
    public double worth(int[] sequence) {
        int image = ImageSources.ORIGINAL;
        for (int wall : sequence) {
            Integer next = children.get(((long) image << Integer.SIZE) + wall);
            if (next == null) {
                return 0.0;
            }
            image = next;
        }
        return worths.get(image);
    }

    /** The walls of the first-order image sources with the greatest worth. */
    public int[] firstWalls(int most) {
        return IntStream.range(1, parents.size())
                .filter(image -> parents.get(image) == ImageSources.ORIGINAL)
                .boxed()
                .sorted(Comparator.comparingDouble((Integer image) -> -worths.get(image))
                        .thenComparingInt(image -> image))
                .limit(most)
                .mapToInt(walls::get)
                .toArray();
    }

    /** The worth of an image source. */
    public double worth(int image) {
        return worths.get(image);
    }

    /**
     * The image sources with the greatest worth. None may be worth more than its parent.
     *
     * @param most maximum number
     * @param least image sources of less worth are left out
     */
    public ImageSources best(int most, double least) {
        int[] kept = IntStream.range(0, parents.size())
                .filter(image -> worths.get(image) >= least)
                .boxed()
                .sorted(Comparator.comparingDouble((Integer image) -> -worths.get(image))
                        .thenComparingInt(image -> image))
                .limit(most)
                .mapToInt(Integer::intValue)
                .sorted()
                .toArray();
        int[] numbers = new int[parents.size()];
        int[] itsParents = new int[kept.length];
        int[] itsWalls = new int[kept.length];
        for (int i = 0; i < kept.length; i++) {
            numbers[kept[i]] = i;
            itsParents[i] = numbers[parents.get(kept[i])];
            itsWalls[i] = walls.get(kept[i]);
        }
        return new ImageSources(itsParents, itsWalls);
    }
}
