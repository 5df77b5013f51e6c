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
    private final String readme;

    ReadmeTest() throws IOException {
        this.readme = Files.readString(Path.of("README.md"));
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
