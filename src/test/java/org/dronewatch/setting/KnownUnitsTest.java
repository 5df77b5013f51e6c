package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;

/** Who mistypes a unit learns which there are. */
class KnownUnitsTest {
    @ParameterizedTest
    @EnumSource(Quantity.class)
    void everyUnitThatIsNamedIsRead(Quantity quantity) {
        for (String unit : KnownUnits.of(quantity)) {
            assertThat(quantity.parse("2 " + unit)).as(unit).isFinite();
        }
    }

    @Test
    void otherWordsForSpeedsAreUnderstood() {
        assertThat(Quantity.SPEED.parse("36kmh")).isCloseTo(10.0, within(1e-9));
        assertThat(Quantity.SPEED.parse("12 knots")).isCloseTo(12 * 1852.0 / 3600.0, within(1e-9));
        assertThat(Quantity.SPEED.parse("10 kn")).isCloseTo(Quantity.SPEED.parse("10 kt"), within(1e-9));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            textBlock =
                    """
            SPEED     | 36 kmhh  | (known units: m/s, km/h, kt, mi/h, ft/s)
            SPEED     | 5 kg     | (known units: m/s, km/h, kt, mi/h, ft/s)
            FREQUENCY | 2.4 ghz  | did you mean 'GHz'?
            ANGLE     | 20 degs  | did you mean 'deg'?
            LENGTH    | 3 metr   | known units: m, km, cm
            PIXELS    | 3 pxl    | known units: px
            """)
    void aMistypedUnitIsAnsweredWithThoseThereAre(Quantity quantity, String text, String hint) {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> quantity.parse(text))
                .withMessageContaining(hint);
    }
}
