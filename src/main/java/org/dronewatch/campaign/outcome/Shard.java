package org.dronewatch.campaign.outcome;

/**
 * A part of a campaign that one of several machines runs: every n-th chunk of its cases.
 *
 * @param number number of the shard, from 1
 * @param of number of shards, 1 to 100,000
 */
public record Shard(int number, int of) {
    /** The whole campaign. */
    public static final Shard ALL = new Shard(1, 1);

    private static final int MOST = 100_000;

    /** Checks the limits. */
    public Shard {
        if (of < 1 || of > MOST || number < 1 || number > of) {
            throw new IllegalArgumentException("must be i/n, with n from 1 to 100,000 and i from 1 to n");
        }
    }

    /**
     * Reads a shard written as in {@code 2/4}.
     *
     * @throws IllegalArgumentException when the text is not a shard
     */
    public static Shard parse(String text) {
        if (!text.matches("\\d{1,6}/\\d{1,6}")) {
            throw new IllegalArgumentException("must be i/n, such as 2/4");
        }
        int slash = text.indexOf('/');
        return new Shard(Integer.parseInt(text.substring(0, slash)), Integer.parseInt(text.substring(slash + 1)));
    }

    /** Whether a chunk belongs to this shard. */
    public boolean has(int chunk) {
        return chunk % of == number - 1;
    }

    /** Whether this is the whole campaign. */
    public boolean isAll() {
        return of == 1;
    }

    @Override
    public String toString() {
        return number + "/" + of;
    }
}
