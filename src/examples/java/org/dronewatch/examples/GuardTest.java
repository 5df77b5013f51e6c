package org.dronewatch.examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.dronewatch.geometry.Position;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.Test;

class GuardTest {
    /** The gate watch with a guard at the gate. */
    static class GuardedGate extends GateWatch {
        @Override
        protected void build() {
            super.build();
            add("guard", new GuardSettings(new Position(0, 45, 134), 1.0, 0.003));
        }
    }

    @Test
    void aGuardNoticesTheIntruderWhereItAppearsLargeEnough() {
        double range =
                new GuardedGate().run().firstDetectionRange("guard", "intruder").orElse(0.0);

        // A drone 0.78 m across subtends 3 mrad at 260 m; it flies 12 m from one look to the next.
        assertTrue(range > 150.0 && range < 270.0, "first seen at " + range + " m");
    }

    @Test
    void settingsOfAnOwnKindTakeUnits() {
        SceneResult result = new SceneRunner(new GuardedGate())
                .set("sensors.guard.acuity", "0.1 deg")
                .set("sensors.guard.rate", "120 /min")
                .run();
        assertTrue(result.firstDetectionRange("guard", "intruder").isPresent());
    }

    @Test
    void settingsOfAnOwnKindHaveLimits() {
        SceneRunner runner = new SceneRunner(new GuardedGate()).set("sensors.guard.acuity", "60 deg");
        InputException problem = assertThrows(InputException.class, runner::run);
        assertEquals(
                "--set sensors.guard.acuity=60 deg: acuity 60 deg must be 0.01718873 to 5.729578 deg",
                problem.getMessage());
    }
}
