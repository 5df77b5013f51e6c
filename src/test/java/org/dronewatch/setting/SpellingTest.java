package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
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
}
