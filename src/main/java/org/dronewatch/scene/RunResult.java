package org.dronewatch.scene;

import java.util.List;

/**
 * What one run of a scene gave.
 *
 * @param run its number in the sweep, from 0
 * @param settings what it ran with
 * @param simulated simulated time, s
 * @param events detections gained and lost, in order of time
 * @param pairs each sensor with each drone, in the order of the scene
 */
public record RunResult(
        int run, SceneSettings settings, double simulated, List<DetectionEvent> events, List<PairResult> pairs) {
    /** Keeps its own lists. */
    public RunResult {
        events = List.copyOf(events);
        pairs = List.copyOf(pairs);
    }
}
