package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.dronewatch.LongForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What twelve bits keep of a margin is true of it. */
class MarginCodeTest {
    private static Margin margin(Margin.Known kind, double db) {
        return new Margin(kind, db);
    }

    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "-0.0, 0",
        "0.04, 0",
        "0.06, 0.1",
        "3, 3",
        "12.34, 12.3",
        "-12.36, -12.4",
        "-0.16, -0.2",
        "51.1, 51.1",
        "51.14, 51.1",
        "-51.1, -51.1",
        "-51.14, -51.1"
    })
    void aValueIsKeptToTheNearestTenth(double db, double kept) {
        assertThat(MarginCode.margin(MarginCode.of(db))).isEqualTo(margin(Margin.Known.VALUE, kept));
    }

    @ParameterizedTest
    @CsvSource({"-5e-324", "-1e-9", "-0.04", "-0.05", "-0.1"})
    void aMarginJustBelowZeroKeepsItsSign(double db) {
        assertThat(MarginCode.margin(MarginCode.of(db))).isEqualTo(margin(Margin.Known.VALUE, -0.1));
    }

    @ParameterizedTest
    @CsvSource({
        "51.16, AT_LEAST, 51.1",
        "300, AT_LEAST, 51.1",
        "Infinity, AT_LEAST, 51.1",
        "-51.16, AT_MOST, -51.1",
        "-300, AT_MOST, -51.1",
        "-1.7e308, AT_MOST, -51.1",
        "-Infinity, NO_SIGNAL, 0",
        "NaN, NOTHING, 0"
    })
    void aValueBeyondTheScaleBecomesABound(double db, Margin.Known kind, double kept) {
        assertThat(MarginCode.margin(MarginCode.of(db))).isEqualTo(margin(kind, kept));
    }

    @ParameterizedTest
    @CsvSource({
        "3.7, AT_LEAST, 3",
        "3, AT_LEAST, 3",
        "0, AT_LEAST, 0",
        "-5e-324, AT_LEAST, -1",
        "-3.2, AT_LEAST, -4",
        "51, AT_LEAST, 51",
        "51.9, AT_LEAST, 51",
        "52, AT_LEAST, 51.1",
        "Infinity, AT_LEAST, 51.1",
        "-51, AT_LEAST, -51",
        "-51.01, NOTHING, 0",
        "-52, NOTHING, 0",
        "-Infinity, NOTHING, 0",
        "NaN, NOTHING, 0"
    })
    void aLowerBoundIsRoundedDown(double db, Margin.Known kind, double kept) {
        assertThat(MarginCode.margin(MarginCode.atLeast(db))).isEqualTo(margin(kind, kept));
    }

    @ParameterizedTest
    @CsvSource({
        "3.2, AT_MOST, 4",
        "3, AT_MOST, 3",
        "0, AT_MOST, 0",
        "-0.7, AT_MOST, 0",
        "5e-324, AT_MOST, 1",
        "-3.7, AT_MOST, -3",
        "-51, AT_MOST, -51",
        "-51.9, AT_MOST, -51",
        "-52, AT_MOST, -51.1",
        "-300, AT_MOST, -51.1",
        "51, AT_MOST, 51",
        "51.01, NOTHING, 0",
        "52, NOTHING, 0",
        "Infinity, NOTHING, 0",
        "NaN, NOTHING, 0",
        "-Infinity, NO_SIGNAL, 0"
    })
    void anUpperBoundIsRoundedUp(double db, Margin.Known kind, double kept) {
        assertThat(MarginCode.margin(MarginCode.atMost(db))).isEqualTo(margin(kind, kept));
    }

    @ParameterizedTest
    @CsvSource({
        "3.68, 3.72, true, VALUE, 3.7",
        "3.68, 3.72, false, VALUE, 3.7",
        "3.68, 5.2, true, AT_LEAST, 3",
        "3.68, 5.2, false, AT_MOST, 6",
        "-0.01, 0.01, true, AT_LEAST, -1",
        "-0.01, 0.01, false, AT_MOST, 1",
        "60, 90, true, AT_LEAST, 51.1",
        "60, 90, false, AT_LEAST, 51.1",
        "-90, -60, true, AT_MOST, -51.1",
        "-Infinity, 3.2, false, AT_MOST, 4",
        "-Infinity, 3.2, true, NOTHING, 0",
        "3.2, Infinity, true, AT_LEAST, 3",
        "3.2, Infinity, false, NOTHING, 0",
        "-Infinity, -Infinity, false, NO_SIGNAL, 0"
    })
    void betweenTwoMarginsIsTheirValueOrTheBoundThatSaysMore(
            double least, double greatest, boolean isDetected, Margin.Known kind, double kept) {
        assertThat(MarginCode.margin(MarginCode.between(least, greatest, isDetected)))
                .isEqualTo(margin(kind, kept));
    }

    @Test
    void whatIsKeptIsTrueOfTheMargin() {
        long seed = LongForm.seed(51);
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 20_000; i++) {
            double db = random.nextDouble(-60.0, 60.0);
            double other = db + random.nextDouble(0.0, 3.0);
            int[] codes = {
                MarginCode.of(db),
                MarginCode.atLeast(db),
                MarginCode.atMost(db),
                MarginCode.between(db, other, true),
                MarginCode.between(db, other, false)
            };
            for (int code : codes) {
                Margin kept = MarginCode.margin(code);
                assertThat(db).as("seed %d: %s", seed, kept).isBetween(kept.least(), kept.greatest());
                assertThat(MarginCode.isPossible(code)).isTrue();
            }
        }
    }

    /** Two without a number, and three kinds with the 1,023 numbers of tenths from -511 to 511. */
    @Test
    void numbersThatStandForNoMarginAreNotPossible() {
        int[] impossible = IntStream.range(0, 1 << MarginCode.BITS)
                .filter(code -> !MarginCode.isPossible(code))
                .toArray();

        assertThat(impossible)
                .containsExactly(IntStream.concat(IntStream.range(2, 1024), IntStream.of(2047, 3071, 4095))
                        .toArray());
    }

    @Test
    void everyMarginHasANumberOfItsOwn() {
        for (int tenths = -511; tenths <= 511; tenths++) {
            double db = tenths / 10.0;
            int code = MarginCode.of(db);
            assertThat(code).isBetween(0, (1 << MarginCode.BITS) - 1);
            assertThat(MarginCode.margin(code)).isEqualTo(margin(Margin.Known.VALUE, db));
        }
        assertThat(MarginCode.margin(MarginCode.NOTHING)).isEqualTo(margin(Margin.Known.NOTHING, 0));
        assertThat(MarginCode.margin(MarginCode.NO_SIGNAL)).isEqualTo(margin(Margin.Known.NO_SIGNAL, 0));
    }
}
