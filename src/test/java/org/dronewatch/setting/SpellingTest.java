package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;

import java.time.Duration;
import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The first name that is offered is the one that a person means. */
class SpellingTest {
    private static final List<String> NAMES = List.of(
            "solid",
            "asphalt",
            "audience",
            "brick_rough",
            "brick_smooth",
            "grass_turf",
            "glass_window",
            "backgroundNoise");

    @ParameterizedTest
    @CsvSource({
        "brik, brick_rough",
        "sollid, solid",
        "gras, grass_turf",
        "glas, glass_window",
        "BackgroundNoise, backgroundNoise",
        "backgrounNoise, backgroundNoise",
        "bricksmooth, brick_smooth"
    })
    void theNearestIsMeant(String typed, String meant) {
        assertThat(Spelling.nearest(typed, NAMES, 1)).containsExactly(meant);
    }

    /** A file may hold a text of any length in the place of a name. */
    @Test
    void veryLongTextsAreComparedAtOnce() {
        List<String> names =
                IntStream.range(0, 1000).mapToObj(i -> "material-" + i).toList();
        String typed = "material-5" + "x".repeat(2_000_000);

        assertTimeoutPreemptively(Duration.ofSeconds(5), () -> assertThat(Spelling.nearest(typed, names, 1))
                .hasSize(1));
        assertThat(Spelling.meant(typed, names)).isEmpty();
    }

    @Test
    void theEndsOfMessagesNameWhatWasMeant() {
        assertThat(Spelling.didYouMean("brik_rough", NAMES)).isEqualTo("; did you mean 'brick_rough'?");
        assertThat(Spelling.didYouMean("xyzxyzxyzxyz", NAMES)).isEmpty();
        assertThat(Spelling.closestMatches("brik", List.of("brick", "solid")))
                .isEqualTo("closest matches: brick, solid");
        assertThat(Spelling.closestMatches("brik", List.of("brick"))).isEqualTo("closest match: brick");
    }
}
