package org.dronewatch.fusion;

/** The latest looks of one sensor at one contact. Not thread-safe. */
public final class ConfirmedLooks {
    private final boolean[] last;
    private final int needed;
    private int next;
    private int hits;

    /** A record to which no look has been added yet. */
    public ConfirmedLooks(Confirmation confirmation) {
        this.last = new boolean[confirmation.looks()];
        this.needed = confirmation.hits();
    }

    /** Adds a look and returns whether the latest looks, including this one, confirm the contact. */
    public boolean add(boolean detected) {
        hits += (detected ? 1 : 0) - (last[next] ? 1 : 0);
        last[next] = detected;
        next = (next + 1) % last.length;
        return hits >= needed;
    }
}
