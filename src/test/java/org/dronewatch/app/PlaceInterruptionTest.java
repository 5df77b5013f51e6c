package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Child;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.campaign.CampaignSite;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * A request to end while {@code place} assesses its candidates: the best layout of those assessed, whole, without
 * attacks; or while it flies these: the results of those that were flown, whole.
 */
@DisabledOnOs(value = OS.WINDOWS, disabledReason = "there a process can only be killed")
class PlaceInterruptionTest {
    private static final List<String> OPTIONS = List.of("-Xmx1g", "-XX:+UseSerialGC");

    @TempDir
    private Path directory;

    @Thorough
    @Test
    void theBestLayoutSoFarIsWhole() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 9\n");
        Files.writeString(file, Files.readString(file).replace("side: 400 m, cell: 80 m", "side: 400 m, cell: 2 m"));
        Files.writeString(
                directory.resolve("attacks.campaign.yaml"),
                "scene: site.yaml\nvary:\n  drones.one.speed: {values: [10, 20]}\nruns: 4\n");
        Outcome outcome;
        try (Child place = Program.start(
                directory,
                List.of("-Xmx1g", "-XX:+UseSerialGC", "-Ddronewatch.cache=" + directory.resolve("cache")),
                ("place radars.place.yaml --campaign attacks.campaign.yaml --threads 1 --progress --out .")
                        .split(" "))) {
            await(() -> hasLayers(2));
            // Not SIGINT, which a build in the background ignores, and with it all that it starts.
            place.process().destroy();
            outcome = place.await();
        }

        assertThat(outcome.code()).as(outcome.err()).isEqualTo(143);
        assertThat(outcome.err())
                .contains("interrupted: this is the best layout so far; no attacks were flown")
                .contains("coverage of candidates: stopped after ")
                .doesNotContain("error")
                .doesNotContain("Exception");
        assertThat(outcome.out()).containsPattern("best layout from the first \\d+ of 14 candidates");
        JsonNode json = json("place.json");
        assertThat(json.get("complete").asBoolean()).isFalse();
        assertThat(json.get("chosen").size()).isPositive();
        assertThat(json.has("campaign")).isFalse();
        assertWhole();
    }

    /** The process waits for the message of an end before there is any result, however slow the console is. */
    @Thorough
    @Test
    void anEndWithoutResultsIsStated() throws Exception {
        Path file = PlacedSite.in(directory, "budget: 9\n");
        Files.writeString(file, Files.readString(file).replace("side: 400 m, cell: 80 m", "side: 400 m, cell: 2 m"));
        String command = "place radars.place.yaml --threads 1 --no-cache --progress --out out";
        Outcome outcome;
        try (Child place = Program.startClass(SlowConsole.class, directory, List.of(), OPTIONS, command.split(" "))) {
            await(() -> Files.readString(place.err()).contains("read "));
            place.process().destroy();
            outcome = place.await();
        }

        assertThat(outcome.code()).as(outcome.err()).isEqualTo(143);
        assertThat(outcome.err()).contains("interrupted: nothing was written");
        assertThat(outcome.out()).isEmpty();
        assertThat(directory.resolve("out")).doesNotExist();
    }

    /** The results of attacks are those of the first ones, as many as are stated. */
    @Thorough
    @Test
    void theAttacksSoFarAreWhole() throws Exception {
        CampaignSite.in(directory, CampaignSite.TWO_RANGES);
        Files.writeString(directory.resolve("radars.place.yaml"), PlaceAttacksTest.CANDIDATES);
        Outcome outcome;
        int flown;
        long wait = 750;
        do {
            // The first attacks are complete after a second, on a busy machine later.
            wait *= 2;
            outcome = interruptedAttacks(wait);
            flown = json("place.json").at("/campaign/variants/layout/n").asInt(0);
        } while (flown == 0 && wait < 30_000);
        assertThat(flown).isPositive();
        JsonNode json = json("place.json");
        Outcome whole = Program.run(
                "place",
                directory.resolve("radars.place.yaml").toString(),
                "--campaign=" + directory.resolve("attacks.campaign.yaml"),
                "--budgets=1",
                "--runs=" + flown,
                "--out=" + directory.resolve("whole"));

        assertThat(outcome.code()).as(outcome.err()).isEqualTo(143);
        assertThat(outcome.err())
                .contains("interrupted: these are the results of the attacks that were complete")
                .doesNotContain("error")
                .doesNotContain("Exception");
        assertThat(json.get("complete").asBoolean()).isFalse();
        assertThat(whole.code()).as(whole.err()).isZero();
        assertThat(json.get("campaign").get("variants"))
                .isEqualTo(json("whole/place.json").get("campaign").get("variants"));
        assertThat(directory.resolve("report.html")).content().contains("the search was interrupted");
        assertWhole();
    }

    /** Ends the command some time after it has begun to fly attacks, ms. */
    private Outcome interruptedAttacks(long wait) throws Exception {
        String command = "place radars.place.yaml --campaign attacks.campaign.yaml --runs 500000 --budgets 1"
                + " --threads 1 --progress --out .";
        try (Child place = Program.start(directory, OPTIONS, command.split(" "))) {
            await(() -> Files.readString(place.err()).contains("coverage of the layout: done"));
            Thread.sleep(wait);
            place.process().destroy();
            return place.await();
        }
    }

    private JsonNode json(String name) {
        return JsonMapper.builder().build().readTree(directory.resolve(name).toFile());
    }

    /** Nothing half-written is left, and the layout can be run. */
    private void assertWhole() throws IOException {
        try (Stream<Path> left = Files.list(directory)) {
            assertThat(left.map(one -> one.getFileName().toString())).noneMatch(name -> name.startsWith(".partial"));
        }
        assertThat(Program.run("check", directory.resolve("layout.yaml").toString())
                        .code())
                .isZero();
    }

    /** Whether some heights of the first candidate have been kept. */
    private boolean hasLayers(int count) throws IOException {
        if (!Files.isDirectory(directory.resolve("cache"))) {
            return false;
        }
        try (Stream<Path> files = Files.walk(directory.resolve("cache"))) {
            return files.filter(Files::isRegularFile).count() > count;
        }
    }

    private static void await(Callable<Boolean> condition) throws Exception {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(60);
        while (!condition.call()) {
            if (System.nanoTime() > end) {
                throw new AssertionError("waited for a minute");
            }
            Thread.sleep(20);
        }
    }
}
