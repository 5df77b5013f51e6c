package org.dronewatch.sensor;

/** Receives every segment of every ray that a sensor traces. */
@FunctionalInterface
public interface RayRecorder {
    /** A recorder that ignores everything. */
    RayRecorder NONE = (fromX, fromY, fromZ, toX, toY, toZ, level, order, received) -> {};

    /**
     * One straight segment of a ray.
     *
     * @param fromX where it begins, m
     * @param fromY where it begins, m
     * @param fromZ where it begins, m
     * @param toX where it ends: at a surface, at the sensor, or after 1 km if it hits nothing, m
     * @param toY where it ends, m
     * @param toZ where it ends, m
     * @param level level of the ray at the end of the segment, dB
     * @param order how many surfaces the ray has hit before it
     * @param received whether it ends at the sensor
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
