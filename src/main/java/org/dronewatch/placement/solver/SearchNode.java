package org.dronewatch.placement.solver;

/**
 * A part of the search: candidates that are decided, and how good, at most, a choice with these decisions can be. It
 * owns the arrays.
 */
record SearchNode(byte[] state, double[] multipliers, double bound) {
    static final byte FREE = 0;
    static final byte IN = 1;
    static final byte OUT = 2;

    /** This node with one more decision. */
    SearchNode with(int candidate, byte decision) {
        byte[] decided = state.clone();
        decided[candidate] = decision;
        return new SearchNode(decided, multipliers.clone(), bound);
    }

    /** The candidates with one decision or the other, ascending. */
    static int[] having(byte[] state, byte one, byte other) {
        int count = 0;
        for (byte decision : state) {
            count += decision == one || decision == other ? 1 : 0;
        }
        int[] having = new int[count];
        int at = 0;
        for (int candidate = 0; candidate < state.length; candidate++) {
            if (state[candidate] == one || state[candidate] == other) {
                having[at++] = candidate;
            }
        }
        return having;
    }
}
