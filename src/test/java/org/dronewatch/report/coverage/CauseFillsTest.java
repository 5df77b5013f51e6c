package org.dronewatch.report.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Color;
import java.util.BitSet;
import java.util.HashMap;
import java.util.Map;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** A map of causes is read by its legend, also in black and white. */
class CauseFillsTest {
    /** All patterns repeat after so many pixels, or after a part of them. */
    private static final int SIDE = 80;

    /** Rec. 709 weights: what a print in black and white keeps. */
    private static double luminance(Color colour) {
        return 0.2126 * colour.getRed() + 0.7152 * colour.getGreen() + 0.0722 * colour.getBlue();
    }

    /** The pixels that are clearly darker than the lightest. */
    private static BitSet pattern(MapSheet.Fill fill, int ground) {
        double[] drawn = new double[SIDE * SIDE];
        double lightest = 0.0;
        for (int i = 0; i < drawn.length; i++) {
            drawn[i] = luminance(new Color(fill.at(i % SIDE, i / SIDE, ground)));
            lightest = Math.max(lightest, drawn[i]);
        }
        BitSet dark = new BitSet();
        for (int i = 0; i < drawn.length; i++) {
            dark.set(i, drawn[i] < lightest - 25.0);
        }
        return dark;
    }

    /** On a dark slope, on open ground, and under the samples of the legend. */
    @ParameterizedTest
    @ValueSource(ints = {0x808080, 0xe8e6e0, 0xd8d4cc})
    void everyCauseHasAPatternOfItsOwn(int ground) {
        Map<BitSet, Cause> patterns = new HashMap<>();
        for (Cause cause : Cause.values()) {
            Cause other = patterns.put(pattern(CauseFills.of(cause), ground), cause);
            assertThat(other).as("looks like %s in black and white", cause).isNull();
        }
    }

    @Test
    void onlyWhatIsDetectedIsPlain() {
        for (Cause cause : Cause.values()) {
            boolean isPlain = pattern(CauseFills.of(cause), 0xc0c0c0).isEmpty();
            assertThat(isPlain).as("%s", cause).isEqualTo(cause == Cause.DETECTED);
        }
    }
}
