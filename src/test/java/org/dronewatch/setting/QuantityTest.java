package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.Locale;
import java.util.Random;
import org.dronewatch.LongForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

class QuantityTest {

    @ParameterizedTest
    @CsvSource({
        "LENGTH, 12, 12",
        "LENGTH, 1.5 km, 1500",
        "LENGTH, 250mm, 0.25",
        "LENGTH, -3 ft, -0.9144",
        "ANGLE, 180 deg, 3.141592653589793",
        "ANGLE, 0.5, 0.5",
        "DURATION, 2 min, 120",
        "ANGULAR_SPEED, 60 deg/s, 1.0471975511965976",
        "TEMPERATURE_DIFFERENCE, 50 mK, 0.05",
        "TEMPERATURE_DIFFERENCE, 5, 5",
        "SPEED, 18 km/h, 5",
        "ACCELERATION, 2 m/s2, 2",
        "FREQUENCY, 2.4 GHz, 2.4e9",
        "AREA, 100 cm^2, 0.01",
        "MASS, 1.4, 1.4",
        "MASS, 250 g, 0.25",
        "TEMPERATURE, 293.15, 293.15",
        "TEMPERATURE, 20 degC, 293.15",
        "TEMPERATURE, -20 degC, 253.15",
        "TEMPERATURE, 68 degF, 293.15",
        "TEMPERATURE, -10 \u00b0C, 263.15",
        "TEMPERATURE, 0 K, 0",
        "PRESSURE, 70 kPa, 70000",
        "PRESSURE, 101325, 101325",
        "PRESSURE, 1013.25 hPa, 101325",
        "PRESSURE, 1 bar, 100000",
        "PRESSURE, 1 atm, 101325",
        "RATIO, 70 %, 0.7",
        "RATIO, 0.7, 0.7",
        "LEVEL, 55 dB, 55",
        "PIXELS, 12 px, 12",
        "NUMBER, 1e-3, 0.001",
    })
    void aNumberMayHaveAUnit(Quantity quantity, String text, double expected) {
        assertThat(quantity.parse(text)).isCloseTo(expected, within(1e-12 * Math.abs(expected)));
    }

    @ParameterizedTest
    @CsvSource({
        "LENGTH, 12 kg",
        "LENGTH, 12 s",
        "ANGLE, 30 m",
        "LEVEL, 3 m",
        "TEMPERATURE, 20 m",
        "PRESSURE, 5 kg",
        "RATIO, 70 dB",
        "NUMBER, 3 m",
        "LENGTH, twelve",
        "LENGTH, NaN",
        "LENGTH, Infinity",
        "LENGTH, 0x10",
        "LENGTH, '1,5'",
        "LENGTH, 1 2",
        "LENGTH, ''",
    })
    void whatIsNoValueOfTheQuantityIsRefused(Quantity quantity, String text) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> quantity.parse(text))
                .withMessageContaining("'" + text + "'");
    }

    @Test
    void readingDoesNotDependOnTheLocale() {
        Locale before = Locale.getDefault();
        try {
            Locale.setDefault(Locale.GERMANY);
            assertThat(Quantity.LENGTH.parse("1.5 km")).isEqualTo(1500.0);
        } finally {
            Locale.setDefault(before);
        }
    }

    @Test
    void aLongTextIsNotRepeatedInFull() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Quantity.LENGTH.parse("9".repeat(5000)))
                .satisfies(e -> assertThat(e.getMessage()).hasSizeLessThan(200));
    }

    @ParameterizedTest
    @EnumSource(Quantity.class)
    void whatIsWrittenExactlyIsReadExactly(Quantity quantity) {
        Random random = new Random(20261123);
        int half = LongForm.count(2500, 10_000);
        for (int i = 0; i < 2 * half; i++) {
            double value = i < half
                    ? Math.scalb(random.nextDouble() - 0.5, random.nextInt(200) - 100)
                    : Math.toRadians(0.1 * (random.nextInt(7200) - 3600));
            assertThat(quantity.parse(quantity.exactly(value)))
                    .as("%s, seed 20261123", quantity.exactly(value))
                    .isEqualTo(value);
        }
        for (double value : new double[] {0.0, -0.0, Double.MIN_VALUE, Double.MAX_VALUE, Math.PI}) {
            assertThat(Double.doubleToLongBits(quantity.parse(quantity.exactly(value))))
                    .as(quantity.exactly(value))
                    .isEqualTo(Double.doubleToLongBits(value));
        }
    }

    /** One notation for small and large limits: powers of ten where they are shorter, never from 0.0001 to 1e6. */
    @ParameterizedTest
    @CsvSource({
        "0, 0",
        "-0.0, 0",
        "1e-12, 1e-12",
        "1e-10, 1e-10",
        "-2.5e-14, -2.5e-14",
        "0.00001, 1e-5",
        "0.0001, 0.0001",
        "0.000123456789, 0.000123456789",
        "200000, 200000",
        "999999.5, 999999.5",
        "1e6, 1e6",
        "2.4e9, 2.4e9",
        "268435456, 268435456",
        "1e12, 1e12",
        "4.9e-324, 4.9e-324",
        "1.7976931348623157e308, 1.7976931348623157e308"
    })
    void numbersInMessagesAreAsShortAsPeopleWriteThem(double value, String text) {
        assertThat(Quantity.NUMBER.inWords(value)).isEqualTo(text);
        assertThat(Quantity.NUMBER.parse(text)).isEqualTo(value);
    }

    @Test
    void exactTextsAreAsPeopleWriteThem() {
        assertThat(Quantity.ANGLE.exactly(Math.toRadians(30))).isEqualTo("30 deg");
        assertThat(Quantity.ANGLE.exactly(Math.toRadians(-39.6))).isEqualTo("-39.6 deg");
        assertThat(Quantity.ANGLE.exactly(0.0)).isEqualTo("0 deg");
        assertThat(Quantity.ANGULAR_SPEED.exactly(Math.toRadians(60))).isEqualTo("60 deg/s");
        assertThat(Quantity.LENGTH.exactly(0.1 + 0.2)).isEqualTo("0.30000000000000004 m");
        assertThat(Quantity.RATIO.exactly(0.5)).isEqualTo("0.5");
        assertThat(Quantity.NUMBER.exactly(7.0)).isEqualTo("7");
    }
}
