package org.dronewatch.bench;

/** Traces the rays of a set; one per thread. */
interface Tracer {
    /** How many pieces the work on a set comes in; pieces can be traced in any order. */
    int pieces();

    /**
     * Traces a piece.
     *
     * @param distances receives the distance of each of its rays, infinity for none
     * @param triangles receives the triangle of each of its rays, -1 for none
     */
    void trace(int piece, float[] distances, int[] triangles);
}
