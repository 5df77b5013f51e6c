package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import com.sun.management.ThreadMXBean;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Map;
import org.assertj.core.api.SoftAssertions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Two hundred broken scene files: each is told of in a line with its place, quickly, and nothing breaks. */
class BrokenSceneFilesTest {
    private static final Duration LONGEST = Duration.ofSeconds(2);
    private static final long MOST_BYTES = 256L << 20;

    @TempDir
    private Path directory;

    private Path scene;
    private String error;

    @BeforeEach
    void site() throws IOException {
        Files.writeString(directory.resolve("site.obj"), "v 0 0 0\nv 900 0 0\nv 0 900 0\nusemtl ground\nf 1 2 3\n");
        scene = directory.resolve("site.yaml");
    }

    private int check() {
        StringWriter err = new StringWriter();
        int code = Main.execute(
                new PrintWriter(new StringWriter()), new PrintWriter(err, true), "check", scene.toString());
        error = err.toString();
        return code;
    }

    @Test
    void theGoodOneIsGood() throws IOException {
        Files.writeString(scene, BrokenSceneFiles.GOOD);
        assertThat(check()).as(() -> error).isZero();
    }

    @Test
    void eachIsRefusedWithItsPlaceQuicklyAndInLittleMemory() throws IOException {
        Map<String, byte[]> files = BrokenSceneFiles.all();
        assertThat(files).hasSizeGreaterThanOrEqualTo(200);
        ThreadMXBean memory = (ThreadMXBean) ManagementFactory.getThreadMXBean();

        // Once before, so that what the libraries set up is not counted to the first file.
        theGoodOneIsGood();
        SoftAssertions all = new SoftAssertions();
        for (Map.Entry<String, byte[]> file : files.entrySet()) {
            Files.write(scene, file.getValue());
            long bytes = memory.getCurrentThreadAllocatedBytes();
            long start = System.nanoTime();
            int code = check();
            Duration time = Duration.ofNanos(System.nanoTime() - start);

            all.assertThat(code).as("%s: %s", file.getKey(), error).isEqualTo(2);
            all.assertThat(error.lines()
                            .filter(line -> !line.startsWith("read ")
                                    && !line.startsWith("warning: ")
                                    && !line.startsWith("... and ")))
                    .as(file.getKey())
                    .isNotEmpty()
                    .allSatisfy(line -> assertThat(line)
                            .satisfiesAnyOf(
                                    one -> assertThat(one).startsWith(scene.toString() + ":"),
                                    one -> assertThat(one).startsWith("sweep of world."),
                                    one -> assertThat(one).startsWith("world.backgroundNoise="),
                                    one -> assertThat(one).startsWith("setting 'world.nothing'"),
                                    one -> assertThat(one).startsWith("no packaged model"))
                            .doesNotContain("Exception")
                            .doesNotContain("\tat ")
                            .hasSizeLessThan(700));
            all.assertThat(time).as(file.getKey()).isLessThan(LONGEST);
            all.assertThat(memory.getCurrentThreadAllocatedBytes() - bytes)
                    .as("bytes allocated for %s", file.getKey())
                    .isLessThan(MOST_BYTES);
        }
        all.assertAll();
    }
}
