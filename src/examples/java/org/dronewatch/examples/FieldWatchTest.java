package org.dronewatch.examples;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.stream.LongStream;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FieldWatchTest {
    @TempDir
    private Path directory;

    @Test
    void theReportIsWritten() {
        SceneResult result = FieldWatch.report(directory.resolve("field"));

        assertTrue(result.firstDetectionRange("radar", "intruder").orElse(0.0) > 300.0);
        assertTrue(Files.exists(directory.resolve("field").resolve("report.html")));
    }

    @Test
    void rangesDifferFromSeedToSeed() {
        long different = LongStream.rangeClosed(1, 5)
                .mapToDouble(FieldWatchTest::range)
                .distinct()
                .count();
        assertTrue(different > 1, "all ranges are the same");
    }

    private static double range(long seed) {
        SceneRunner runner = new SceneRunner(new FieldWatch()).seed(seed).set("sensors.microphone.enabled", "false");
        return runner.run().firstDetectionRange("radar", "intruder").orElseThrow();
    }
}
