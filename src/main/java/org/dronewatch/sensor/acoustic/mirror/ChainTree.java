package org.dronewatch.sensor.acoustic.mirror;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;

/** Chains of walls as they are found, with what each of them is worth. */
public final class ChainTree {
    private final List<Integer> parents = new ArrayList<>(List.of(MirrorChains.EMPTY));
    private final List<Integer> walls = new ArrayList<>(List.of(WallPlanes.NONE));
    private final List<Double> worths = new ArrayList<>(List.of(Double.POSITIVE_INFINITY));
    private final Map<Long, Integer> children = new HashMap<>();

    /**
     * Adds a chain unless it is known, and what it is worth.
     *
     * @return its number
     */
    public int add(int parent, int wall, double worth) {
        int chain = children.computeIfAbsent(((long) parent << Integer.SIZE) + wall, key -> {
            parents.add(parent);
            walls.add(wall);
            worths.add(0.0);
            return parents.size() - 1;
        });
        worths.set(chain, worths.get(chain) + worth);
        return chain;
    }

    /** Adds a chain of walls, the first one first, and all chains that it begins with. */
    public void add(int[] sequence, double worth) {
        int chain = MirrorChains.EMPTY;
        for (int wall : sequence) {
            chain = add(chain, wall, worth);
        }
    }

    /** What a chain of walls is worth; 0 if it is not known. */
    public double worth(int[] sequence) {
        int chain = MirrorChains.EMPTY;
        for (int wall : sequence) {
            Integer next = children.get(((long) chain << Integer.SIZE) + wall);
            if (next == null) {
                return 0.0;
            }
            chain = next;
        }
        return worths.get(chain);
    }

    /** The walls of the chains of one wall that are worth most. */
    public int[] firstWalls(int most) {
        return IntStream.range(1, parents.size())
                .filter(chain -> parents.get(chain) == MirrorChains.EMPTY)
                .boxed()
                .sorted(Comparator.comparingDouble((Integer chain) -> -worths.get(chain))
                        .thenComparingInt(chain -> chain))
                .limit(most)
                .mapToInt(walls::get)
                .toArray();
    }

    /** What a chain is worth. */
    public double worth(int chain) {
        return worths.get(chain);
    }

    /**
     * The chains of the greatest worth. No chain may be worth more than what it begins with.
     *
     * @param most how many
     * @param least chains that are worth less are left out
     */
    public MirrorChains best(int most, double least) {
        int[] kept = IntStream.range(0, parents.size())
                .filter(chain -> worths.get(chain) >= least)
                .boxed()
                .sorted(Comparator.comparingDouble((Integer chain) -> -worths.get(chain))
                        .thenComparingInt(chain -> chain))
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
        return new MirrorChains(itsParents, itsWalls);
    }
}
