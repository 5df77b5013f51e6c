package org.dronewatch.examples;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.dronewatch.run.SceneResult;
import org.junit.jupiter.api.Test;

class GateWatchTest {
    @Test
    void theRoofCameraSeesTheIntruderBeforeTheTurn() {
        SceneResult result = new GateWatch().run();
        double range = result.firstDetectionRange("roof", "intruder").orElse(0.0);
        assertTrue(range > 120.0, "first seen only at " + range + " m");
    }
}
