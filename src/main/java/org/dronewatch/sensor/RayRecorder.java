package org.dronewatch.sensor;

/** Receives the segments of the rays that a sensor traces; the sensor states which of its rays these are. */
@FunctionalInterface
public interface RayRecorder {
    /** A recorder that ignores everything. */
    RayRecorder NONE = (fromX, fromY, fromZ, toX, toY, toZ, level, order, received) -> {};

    /**
     * One straight segment of a ray.
     *
     * @param fromX x coordinate of its start, m
     * @param fromY y coordinate of its start, m
     * @param fromZ z coordinate of its start, m
     * @param toX x coordinate of its end, m: at a surface, at the sensor (or at the drone, for rays that start from the
     *     sensor), or after 1 km if the ray hits nothing
     * @param toY y coordinate of its end, m
     * @param toZ z coordinate of its end, m
     * @param level level of the ray: in the level model, at the end of the segment, dB on the calibrated scale of that
     *     model; in the energy model, the level of the sound power that the ray carries at the start of the segment, dB
     *     re 1 pW
     * @param order number of surfaces that the ray has hit before this segment
     * @param received whether the segment ends at the sensor; in the energy model, whose rays may start from the sensor
     *     instead of the drone, whether the segment ends at whichever of the two the rays do not start from
     */
    void record(
            double fromX,
            double fromY,
            double fromZ,
            double toX,
            double toY,
            double toZ,
            double level,
            int order,
            boolean received);
}
