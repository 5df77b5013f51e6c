package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.dronewatch.Thorough;
import org.dronewatch.app.Program.Outcome;
import org.dronewatch.placement.site.PlacedSite;
import org.junit.jupiter.api.extension.AnnotatedElementContext;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.io.TempDirFactory;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** What {@code place} promises of a layout is what {@code coverage} finds for its scene. */
class PlacePromiseTest {
    /** Below the current directory, so that printed paths are relative, and with a name that needs quotation marks. */
    static final class OddlyNamed implements TempDirFactory {
        @Override
        public Path createTempDirectory(AnnotatedElementContext element, ExtensionContext context) throws IOException {
            return Files.createTempDirectory(Path.of("target"), "today's site ");
        }
    }

    @TempDir(factory = OddlyNamed.class)
    private Path directory;

    @Thorough
    @ParameterizedTest
    @ValueSource(strings = {"any", "inbound"})
    void coverageOfTheLayoutGivesTheFiguresThatWerePrinted(String heading) throws IOException {
        Path file = PlacedSite.in(directory, "budget: 12\n");
        Files.writeString(
                file, Files.readString(file).replace("air: {", "air: {heading: " + heading + ", covered: 0.4, "));
        Path site = directory.resolve("site.yaml");
        Files.writeString(site, Files.readString(site) + "alert: {protect: {centre: [40, 20, 0], radius: 20}}\n");
        Outcome place = Program.run("place", file.toString(), "--budgets=2", "--out=" + directory.resolve("."));
        assertThat(place.code()).as(place.err()).isZero();
        List<String> words = new ArrayList<>(ShellWords.printed(place.out(), "coverage"));
        assertThat(words).contains(directory.resolve("layout.yaml").toString());
        words.add("--out=" + directory.resolve("field"));
        Outcome coverage = Program.run(words.toArray(String[]::new));
        assertThat(coverage.code()).as(coverage.err()).isZero();

        JsonNode heights = json("field/coverage.json").get("heights");
        assertThat(heights.size()).isEqualTo(2);
        double known = 0.0;
        double covered = 0.0;
        for (JsonNode height : heights) {
            double share = height.get("covered_share").asDouble();
            double worst = share;
            for (JsonNode lost : height.get("n_minus_1")) {
                worst = Math.min(worst, share - lost.asDouble());
            }
            assertThat(height.get("unknown_share").asDouble()).isZero();
            assertThat(place.out())
                    .containsPattern(String.format(
                            Locale.ROOT,
                            "(?m)^ *%.0f m +\\S+ +%.1f +\\S+ +%.1f +\\S+ +%.1f$",
                            height.get("height_m").asDouble(),
                            100.0 * share,
                            100.0 * worst,
                            1e-4 * height.get("largest_gap_m2").asDouble()));
            known += height.get("known").asDouble();
            covered += share * height.get("known").asDouble();
        }
        if (heading.equals("inbound")) {
            assertThat(json("place.json").get("value").asDouble()).isCloseTo(covered / known, within(1e-6));
        } else {
            assertThat(place.out())
                    .contains(String.format(
                            Locale.ROOT, "the layout covers %.1f %% of the known cells", 100.0 * covered / known));
        }
        assertThat(covered).isPositive();
    }

    private JsonNode json(String name) {
        return JsonMapper.builder().build().readTree(directory.resolve(name).toFile());
    }
}
