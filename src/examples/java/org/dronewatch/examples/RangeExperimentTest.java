package org.dronewatch.examples;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import org.djutils.stats.summarizers.Tally;
import org.dronewatch.scene.SceneFile;
import org.junit.jupiter.api.Test;

class RangeExperimentTest {
    @Test
    void theRadarDetectsTheIntruderInEveryReplication() throws InterruptedException {
        Tally ranges = new RangeExperiment("radar", "intruder")
                .run(simulator -> new SceneFile(Path.of("scenes/birds.yaml"), simulator), 50.0, 10);
        assertEquals(10, ranges.getN());
        double lower = ranges.getConfidenceInterval(0.05)[0];
        assertTrue(lower > 700.0, "the mean range may be as low as " + lower + " m");
        assertTrue(ranges.getSampleStDev() > 1.0, "each replication draws its own random numbers");
    }

    @Test
    void aSceneInJavaIsReplicatedToo() throws InterruptedException {
        Tally ranges = new RangeExperiment("radar", "intruder").run(FieldWatch::new, 45.0, 2);
        assertEquals(2, ranges.getN());
    }
}
