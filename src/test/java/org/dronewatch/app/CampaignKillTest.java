package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Child;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.campaign.CampaignSite;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A campaign in a process that is killed, and completed: its files are those of a campaign that was left alone. */
class CampaignKillTest {
    /** Four chunks of cases that take some milliseconds each, eight in the long form. */
    private static final String CAMPAIGN =
            CampaignSite.TWO_RANGES.replace("runs: 60", "runs: " + LongForm.count(190, 390));

    /** Of the seconds that a campaign in a process takes, the first is for the start of Java. */
    private static final int LONGEST_MILLIS = LongForm.count(1800, 2500);

    @TempDir
    private Path directory;

    private Path whole;

    @BeforeEach
    void runWithoutInterruption() throws IOException {
        CampaignSite.in(directory, CAMPAIGN);
        whole = directory.resolve("whole");
        Outcome outcome = Program.run("campaign", file(), "--out", whole.toString());
        assertThat(outcome.code()).as(outcome.err()).isZero();
    }

    private String file() {
        return directory.resolve("attacks.campaign.yaml").toString();
    }

    private static List<String> bytes(Path results) throws IOException {
        return List.of(
                Files.readString(results.resolve("runs.csv")),
                Files.readString(results.resolve("campaign.json")),
                Files.readString(results.resolve("plan.json")));
    }

    /** Half of the moments are those at which a file is being written or renamed, and the others any. */
    @Thorough
    @Test
    void nothingIsLostDoubledOrDifferentWhenItIsKilledAtAnyMoment() throws Exception {
        long seed = 20_261_126L;
        System.out.println("seed of the moments: " + seed);
        SplittableRandom random = new SplittableRandom(seed);
        int kills = LongForm.count(2, 30);
        int killed = 0;
        for (int campaign = 0; killed < kills; campaign++) {
            Path results = directory.resolve("killed-" + campaign);
            boolean ended = false;
            while (!ended && killed < kills) {
                ended = endsBeforeItIsKilled(results, killed % 2 == 0, random);
                killed += ended ? 0 : 1;
            }
            Outcome last = Program.run("campaign", file(), "--out", results.toString(), "--resume");
            assertThat(last.code()).as(last.err()).isZero();
            assertThat(bytes(results)).as("after %d kills", killed).isEqualTo(bytes(whole));
            assertNothingIsLeft(results);
        }
    }

    private boolean endsBeforeItIsKilled(Path results, boolean amidFiles, SplittableRandom random) throws Exception {
        int unfinished = random.nextInt(1, 6);
        long millis = random.nextLong(300, LONGEST_MILLIS);
        try (Child child = Program.start(
                directory,
                List.of("-Xmx512m", "-XX:+UseSerialGC"),
                "campaign",
                file(),
                "--out",
                results.toString(),
                "--resume")) {
            if (amidFiles) {
                awaitUnfinished(child, results.resolve("chunks"), unfinished);
            } else {
                child.process().waitFor(millis, TimeUnit.MILLISECONDS);
            }
            boolean ended = !child.process().isAlive();
            child.process().destroyForcibly();
            Outcome outcome = child.await();
            assertThat(outcome.code()).as(outcome.err()).isIn(0, 137);
            return ended;
        }
    }

    /** Waits, without a pause, until a file that is not finished was seen so many times. */
    private static void awaitUnfinished(Child child, Path chunks, int times) throws IOException {
        int seen = 0;
        while (child.process().isAlive() && seen < times) {
            if (Files.isDirectory(chunks)) {
                try (DirectoryStream<Path> files = Files.newDirectoryStream(chunks, ".partial-*")) {
                    seen += files.iterator().hasNext() ? 1 : 0;
                }
            }
        }
    }

    private static void assertNothingIsLeft(Path results) throws IOException {
        try (Stream<Path> files = Files.walk(results)) {
            assertThat(files.map(file -> file.getFileName().toString()))
                    .noneMatch(name -> name.startsWith(".partial") || name.equals(".lock"));
        }
    }
}
