package org.dronewatch.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Random;
import org.dronewatch.LongForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Numbers of model files are those that Java reads, to the last bit. */
class PlainDecimalTest {
    private static double read(String text) {
        return PlainDecimal.read(("<" + text + ">").toCharArray(), 1, 1 + text.length());
    }

    @Test
    void whatIsReadIsWhatJavaReads() {
        long seed = LongForm.seed(27);
        Random random = new Random(seed);
        int safe = 0;
        int count = LongForm.count(200_000, 20_000_000);
        for (int i = 0; i < count; i++) {
            String digits = String.valueOf(Math.abs(random.nextLong()));
            int length = 1 + random.nextInt(PlainDecimal.MOST_DIGITS);
            StringBuilder text = new StringBuilder(digits.substring(0, Math.min(length, digits.length())));
            if (random.nextInt(8) > 0) {
                text.insert(random.nextInt(text.length() + 1), '.');
            }
            text.insert(0, new String[] {"", "-", "+"}[random.nextInt(3)]);
            double read = read(text.toString());
            String what = text + ", seed " + seed;
            assertThat(read).as(what).isEqualTo(Double.parseDouble(text.toString()));
            if (PlainDecimal.isSafeAsFloat(read)) {
                safe++;
                assertThat((float) read).as(what).isEqualTo(Float.parseFloat(text.toString()));
            }
        }
        assertThat(safe).isGreaterThan(count / 2);
    }

    /** Rounded to a double first, these round to the wrong one of two floats. */
    @ParameterizedTest
    @ValueSource(strings = {"1.00000005960464", "1.00000017881393", "16777217", "3.00000011920929"})
    void closeToTheMiddleBetweenTwoFloatsTheDoubleIsSafeOnlyIfItRoundsAlike(String text) {
        double read = read(text);

        assertThat(PlainDecimal.isSafeAsFloat(read) && (float) read != Float.parseFloat(text))
                .isFalse();
    }

    @Test
    void aDoubleInTheMiddleBetweenTwoFloatsIsNotSafe() {
        assertThat(PlainDecimal.isSafeAsFloat(16_777_217.0)).isFalse();
        assertThat(PlainDecimal.isSafeAsFloat(16_777_218.0)).isTrue();
    }

    @Test
    void theSignOfZeroIsKept() {
        assertThat(1.0 / read("-0.0")).isEqualTo(Double.NEGATIVE_INFINITY);
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "-",
                "+",
                ".",
                "-.",
                "1e3",
                "1,5",
                "1.2.3",
                "--1",
                "NaN",
                "0x1",
                "1f",
                "\u0663",
                "1234567890123456"
            })
    void everythingElseIsLeftToJava(String text) {
        assertThat(read(text)).isNaN();
    }
}
