package org.dronewatch.report.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import org.dronewatch.analysis.cell.FieldGrid;
import org.junit.jupiter.api.Test;

/** A map of heights is read by its legend, also in black and white. */
class HeightFillsTest {
    private static final FieldGrid GRID = new FieldGrid(0, 0, 100, 10, List.of(10.0, 30.0, 60.0, 120.0, 150.0));

    /** Under the samples of the legend. */
    private static final int LEGEND = 0xd8d4cc;

    /** The darkest slope that faces away from the light, and a road. */
    private static final int[] GROUNDS = {0x3b3a38, 0xfafafa};

    /** Rec. 709 weights: what a print in black and white keeps. */
    private static double luminance(int pixel) {
        Color colour = new Color(pixel);
        return 0.2126 * colour.getRed() + 0.7152 * colour.getGreen() + 0.0722 * colour.getBlue();
    }

    @Test
    void everyClassLooksLikeItsOwnSampleWhateverTheGround() {
        List<Double> heights = new ArrayList<>(HeightFills.bounds(GRID));
        heights.add(Double.NaN);
        for (Double height : heights) {
            for (int ground : GROUNDS) {
                double drawn = luminance(HeightFills.of(GRID, height).at(0, 0, ground));
                Double nearest = heights.stream()
                        .min(Comparator.comparingDouble(other ->
                                Math.abs(luminance(HeightFills.of(GRID, other).at(0, 0, LEGEND)) - drawn)))
                        .orElseThrow();
                assertThat(nearest).as("height %s on %06x", height, ground).isEqualTo(height);
            }
        }
    }

    /** The highest class is dark, too: only lines tell it from none. */
    @Test
    void noneIsLined() {
        for (int ground : GROUNDS) {
            List<Double> none = new ArrayList<>();
            List<Double> highest = new ArrayList<>();
            for (int u = 0; u < 16; u++) {
                none.add(luminance(HeightFills.of(GRID, Double.NaN).at(u, 3, ground)));
                highest.add(luminance(HeightFills.of(GRID, 150).at(u, 3, ground)));
            }
            assertThat(Collections.max(none) - Collections.min(none)).isGreaterThan(100);
            assertThat(new HashSet<>(highest)).hasSize(1);
        }
    }
}
