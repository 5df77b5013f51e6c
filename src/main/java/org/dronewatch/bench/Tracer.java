package org.dronewatch.bench;

/** Traces the rays of a set; one per thread. */
interface Tracer {
    /** Number of pieces into which the work on a set is divided; they can be traced in any order. */
    int pieces();

    /**
     * Traces a piece.
     *
     * @param distances receives the distance of each of its rays, infinity for none; unchanged for an occlusion query
     * @param triangles receives the triangle of each of its rays, -1 for none; 0 for any in an occlusion query
     */
    void trace(int piece, float[] distances, int[] triangles);
}
