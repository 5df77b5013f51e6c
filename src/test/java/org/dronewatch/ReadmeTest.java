package org.dronewatch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronewatch.run.PairResult;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenes.CameraRange;
import org.junit.jupiter.api.Test;

/** The README must not promise what is not so. */
class ReadmeTest {
    private static final Path EXAMPLES = Path.of("src", "examples", "java", "org", "dronewatch", "examples");

    private final String readme;

    ReadmeTest() throws IOException {
        this.readme = Files.readString(Path.of("README.md"));
    }

    /** The readme's own, and that of the page that it leads to. */
    @Test
    void itsJavaIsThatOfTheExamples() throws IOException {
        String sources = Files.readString(EXAMPLES.resolve("GateWatch.java"))
                + Files.readString(EXAMPLES.resolve("GateWatchTest.java"))
                + Files.readString(EXAMPLES.resolve("FieldWatch.java"))
                + Files.readString(EXAMPLES.resolve("RangeExperiment.java"))
                + Files.readString(EXAMPLES.resolve("RangeExperimentTest.java"));
        String pages = readme + Files.readString(Path.of("src", "site", "markdown", "java.md"));
        Matcher blocks = Pattern.compile("```java\n(.*?)```", Pattern.DOTALL).matcher(pages);
        int found = 0;
        while (blocks.find()) {
            assertThat(sources).contains(blocks.group(1).stripTrailing());
            found++;
        }
        assertThat(found).isEqualTo(7);
    }

    @Test
    void itsLinksLeadToFiles() {
        Matcher links = Pattern.compile("]\\(([^)#]+)\\)").matcher(readme);
        while (links.find()) {
            assertThat(Path.of(links.group(1))).exists();
        }
    }

    @Test
    void itsTableHoldsTheRangesOfTheScene() {
        SceneResult result = new CameraRange().run();
        List<PairResult> pairs = result.pairs();
        int[] degrees = {30, 36, 45, 60, 90};
        for (int run = 0; run < degrees.length; run++) {
            double law = new CameraRange()
                    .expectedRange(result.runs().get(run).settings(), "camera")
                    .orElseThrow();
            double range = pairs.get(run).range().orElseThrow();
            assertThat(readme)
                    .contains(String.format(Locale.ROOT, "| %d° | %.1f m | %.1f m |", degrees[run], range, law));
        }
    }
}
