package org.dronewatch.fuzz;

import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.IntStream;

/** Random choices. */
public final class Dice {
    private final SplittableRandom random;

    /** Dice that fall the same for the same seed. */
    public Dice(long seed) {
        this.random = new SplittableRandom(seed);
    }

    /** The underlying generator. */
    public SplittableRandom random() {
        return random;
    }

    /** A number of at least 0 and below a limit. */
    public int below(int limit) {
        return random.nextInt(limit);
    }

    /** A number from one to another, both included. */
    public int between(int least, int most) {
        return random.nextInt(least, most + 1);
    }

    /** Uniform between two numbers. */
    public double between(double low, double high) {
        return low + (high - low) * random.nextDouble();
    }

    /** True once in the given number of times, on average. */
    public boolean oneIn(int times) {
        return random.nextInt(times) == 0;
    }

    /** One of several things. */
    @SafeVarargs
    public final <T> T pick(T... things) {
        return things[random.nextInt(things.length)];
    }

    /** One of a list. */
    public <T> T pick(List<T> things) {
        return things.get(random.nextInt(things.size()));
    }

    /** A text of several parts, each chosen separately. */
    public String several(int count, List<String> parts) {
        return IntStream.range(0, count).mapToObj(i -> pick(parts)).collect(Collectors.joining());
    }
}
