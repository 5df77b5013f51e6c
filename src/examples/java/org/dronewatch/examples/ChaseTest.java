package org.dronewatch.examples;

import static org.junit.jupiter.api.Assertions.assertTrue;

import org.dronewatch.drone.Drone;
import org.dronewatch.run.Frame;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;

class ChaseTest {
    private double nearest = Double.POSITIVE_INFINITY;

    private void look(Frame frame) {
        Drone visitor = frame.drones().get(0);
        Drone guard = frame.drones().get(1);
        nearest = Math.min(nearest, visitor.distance(guard.origin()));
    }

    @Test
    void theGuardCatchesTheVisitor() {
        new SceneRunner(new Chase()).onFrame(this::look).run();
        assertTrue(nearest < 4.0, "came no nearer than " + nearest + " m");
    }
}
