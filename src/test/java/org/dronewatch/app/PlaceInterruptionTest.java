package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dronewatch.app.Program.Child;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** A request to end while {@code place} assesses its candidates: the best layout of those assessed, whole. */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "there a process can only be killed")
class PlaceInterruptionTest {
    @TempDir
    private Path directory;

    @Test
    void theBestLayoutSoFarIsWhole() throws IOException, InterruptedException {
        Path file = PlacedSite.in(directory, "budget: 9\n");
        Files.writeString(file, Files.readString(file).replace("side: 400 m, cell: 80 m", "side: 400 m, cell: 2 m"));
        Outcome outcome;
        try (Child place = Program.start(
                directory,
                List.of("-Xmx1g", "-Ddronewatch.cache=" + directory.resolve("cache")),
                ("place radars.place.yaml --threads 1 --out .").split(" "))) {
            awaitLayers(2);
            // Not SIGINT, which a build in the background ignores, and with it all that it starts.
            place.process().destroy();
            outcome = place.await();
        }

        assertThat(outcome.code()).as(outcome.err()).isEqualTo(143);
        assertThat(outcome.err())
                .contains("interrupted: this is the best layout so far")
                .doesNotContain("error")
                .doesNotContain("Exception");
        assertThat(outcome.out()).contains("best layout from 14 candidates");
        JsonNode json = JsonMapper.builder()
                .build()
                .readTree(directory.resolve("place.json").toFile());
        assertThat(json.get("complete").asBoolean()).isFalse();
        assertThat(json.get("chosen").size()).isPositive();
        assertThat(directory.resolve("layout.yaml")).exists();
        try (Stream<Path> left = Files.list(directory)) {
            assertThat(left.map(one -> one.getFileName().toString())).noneMatch(name -> name.startsWith(".partial"));
        }
        assertThat(Program.run("check", directory.resolve("layout.yaml").toString())
                        .code())
                .isZero();
    }

    /** Waits until some heights of the first candidate have been kept. */
    private void awaitLayers(int count) throws IOException, InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
        while (System.nanoTime() < end) {
            if (Files.isDirectory(directory.resolve("cache"))) {
                try (Stream<Path> files = Files.walk(directory.resolve("cache"))) {
                    if (files.filter(Files::isRegularFile).count() > count) {
                        return;
                    }
                }
            }
            Thread.sleep(20);
        }
        throw new AssertionError("nothing was assessed within a minute");
    }
}
