package org.dronewatch.campaign.variation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.apache.commons.numbers.gamma.Erfc;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class VariationTest {
    private static final double TINY = 1e-8;

    private static Variation uniform(String from, String to) {
        return Variation.of(new Uniform(from, to));
    }

    private static Variation with(String distribution, Object of) {
        return SettingsForm.with(Variation.NONE, distribution, Optional.of(of));
    }

    private static Variation normal(Normal normal) {
        return with("normal", normal);
    }

    private static Variation triangular(String from, String mode, String to) {
        return with("triangular", new Triangular(from, mode, to));
    }

    private static Variation counted(String from, String to, int count) {
        return with("range", new EvenlySpaced(from, to, Optional.of(count), Optional.empty()));
    }

    private static Variation stepped(String from, String to, String step) {
        return with("range", new EvenlySpaced(from, to, Optional.empty(), Optional.of(step)));
    }

    /** The values of equally many random numbers each. */
    private static List<String> all(Variation variation, Quantity quantity, int count) {
        return IntStream.range(0, count)
                .mapToObj(i -> {
                    String value = variation.value(quantity, (i + 1e-9) / count);
                    assertThat(variation.value(quantity, (i + 1.0 - 1e-9) / count))
                            .isEqualTo(value);
                    return value;
                })
                .toList();
    }

    private static double metres(Variation variation, double u) {
        return Quantity.LENGTH.parse(variation.value(Quantity.LENGTH, u));
    }

    @Test
    void uniformValuesAreInTheRange() {
        assertThat(metres(uniform("10 m", "0.03 km"), 0.25)).isEqualTo(15.0);
        assertThat(uniform("0 deg", "360 deg").value(Quantity.ANGLE, 0.5)).isEqualTo("180 deg");
        assertThat(uniform("5", "6").value(Quantity.NUMBER, 0.125)).isEqualTo("5.125");
    }

    /** Its cumulative distribution is (x - a)^2 / ((b - a)(m - a)) up to the mode m. */
    @Test
    void triangularValuesFollowTheirDistribution() {
        Variation variation = triangular("0", "3", "10");
        for (double u = 0.01; u < 1.0; u += 0.01) {
            double x = metres(variation, u);
            double cumulative = x <= 3.0 ? x * x / 30.0 : 1.0 - (10.0 - x) * (10.0 - x) / 70.0;
            assertThat(cumulative).as("u = %s", u).isCloseTo(u, within(TINY));
        }
        assertThat(metres(triangular("0", "0", "10"), 0.75)).isCloseTo(5.0, within(TINY));
        assertThat(metres(triangular("0", "10", "10"), 0.25)).isCloseTo(5.0, within(TINY));
    }

    /** Quantiles of the standard normal distribution from tables: 1.2815515655 at .9, 1.9599639845 at .975. */
    @ParameterizedTest
    @CsvSource({".5, 100", ".9, 112.815515655", ".975, 119.599639845", ".025, 80.400360155"})
    void normalValuesFollowTheirDistribution(double u, double x) {
        assertThat(metres(normal(Normal.of("100 m", "10 m")), u)).isCloseTo(x, within(1e-4));
    }

    @Test
    void normalValuesKeepTheirLimits() {
        Variation above = normal(new Normal("100", "10", Optional.of("100"), Optional.empty()));

        assertThat(metres(above, 0.0)).isEqualTo(100.0);
        // Half of what is left lies within .6744897502 standard deviations: P(Z < .6745) = .75.
        assertThat(metres(above, 0.5)).isCloseTo(106.744897502, within(1e-4));
        assertThat(metres(above, Math.nextDown(1.0))).isLessThanOrEqualTo(150.0);
        assertThatThrownBy(() -> metres(normal(new Normal("0", "1", Optional.of("40"), Optional.of("50"))), 0.5))
                .hasMessage("'from' 40.0 and 'to' 50.0 leave out all of the normal distribution with mean 0.0 and"
                        + " deviation 1.0");
    }

    /** A normal distribution above its mean has the mean (phi(a) - phi(b)) / (Q(a) - Q(b)), by Q(z) = P(Z > z). */
    @ParameterizedTest
    @CsvSource({"3.1, 3.5", "8.1, 8.5", "12, 30", "20, 20.01", "-8.5, -8.1"})
    void normalValuesFarFromTheMeanKeepTheirDigits(double a, double b) {
        Variation tail = normal(new Normal("1", "1", Optional.of("" + (1.0 + a)), Optional.of("" + (1.0 + b))));
        int count = 20_000;
        double sum = 0.0;
        double before = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double value = Double.parseDouble(tail.value(Quantity.NUMBER, (i + 0.5) / count));
            assertThat(value).isBetween(1.0 + a, 1.0 + b).isGreaterThanOrEqualTo(before);
            before = value;
            sum += value;
        }
        double near = Math.abs(a) < Math.abs(b) ? Math.abs(a) : Math.abs(b);
        double far = Math.max(Math.abs(a), Math.abs(b));
        double mean = (density(near) - density(far)) / (beyond(near) - beyond(far));

        assertThat(sum / count).isCloseTo(1.0 + Math.signum(a) * mean, within(1e-5));
    }

    private static double density(double z) {
        return Math.exp(-z * z / 2.0) / Math.sqrt(2.0 * Math.PI);
    }

    private static double beyond(double z) {
        return 0.5 * Erfc.value(z / Math.sqrt(2.0));
    }

    @Test
    void aNormalDistributionThatLeavesTheRangeOfNumbersIsRefused() {
        assertThatThrownBy(() -> normal(Normal.of("1e308", "1e308")).value(Quantity.NUMBER, 0.5))
                .hasMessage("mean 1.0E308 and deviation 1.0E308 give values too large for a number; set smaller"
                        + " ones, or set 'from' and 'to'");
    }

    @Test
    void listedValuesAreEquallyLikely() {
        Variation variation = with("values", List.of("a", "b", "c"));

        assertThat(variation.value(Quantity.NUMBER, 0.0)).isEqualTo("a");
        assertThat(variation.value(Quantity.NUMBER, 0.34)).isEqualTo("b");
        assertThat(variation.value(Quantity.NUMBER, Math.nextDown(1.0))).isEqualTo("c");
        assertThat(variation.extremes(Quantity.NUMBER)).containsExactly("a", "b", "c");
    }

    @Test
    void evenlySpacedValuesAreEquallyLikely() {
        assertThat(all(counted("10 m", "0.03 km", 5), Quantity.LENGTH, 5))
                .containsExactly("10 m", "15 m", "20 m", "25 m", "30 m");
        assertThat(all(stepped("0 deg", "315 deg", "45 deg"), Quantity.ANGLE, 8))
                .containsExactly("0 deg", "45 deg", "90 deg", "135 deg", "180 deg", "225 deg", "270 deg", "315 deg");
        assertThat(all(stepped("1 m", "2 m", "0.4 m"), Quantity.LENGTH, 3))
                .as("2 m is not a multiple")
                .containsExactly("1 m", "1.4 m", "1.8 m");
        assertThat(all(stepped("0", "0.3", "0.1"), Quantity.NUMBER, 4))
                .as("0.3 / 0.1 is a little less than 3")
                .containsExactly("0", "0.1", "0.2", "0.3");
        assertThat(all(stepped("10 degC", "30 degC", "10 degC"), Quantity.TEMPERATURE, 3))
                .containsExactly("283.15 K", "293.15 K", "303.15 K");
        assertThat(stepped("5 m", "25 m", "5 m").extremes(Quantity.LENGTH)).containsExactly("5 m", "25 m");
    }

    @Test
    void theSpacingMustBeStatedOnceAndFit() {
        assertThatThrownBy(() -> stepped("5 m", "5 m", "1 m").value(Quantity.LENGTH, 0.5))
                .hasMessage("'from' 5.0 must be below 'to' 5.0");
        assertThatThrownBy(() -> stepped("0 m", "5 m", "0 m").value(Quantity.LENGTH, 0.5))
                .hasMessage("step 0.0 must be above 0");
        assertThatThrownBy(() -> stepped("0 m", "5 m", "6 m").value(Quantity.LENGTH, 0.5))
                .hasMessage("step 6.0 must be at most 5.0, the difference between 'from' and 'to'");
        assertThatThrownBy(() -> stepped("0 m", "5 km", "0.5 m").value(Quantity.LENGTH, 0.5))
                .hasMessage("step 0.5 gives too many values; it must give at most 10,000");
        assertThatThrownBy(() -> stepped("0 m", "5 m", "1 kg").value(Quantity.LENGTH, 0.5))
                .hasMessageStartingWith("step: ");
        assertThatThrownBy(() -> counted("0 m", "5 m", 1)).hasMessageContaining("count 1 must be 2 to 10000");
        assertThatThrownBy(with("range", EvenlySpaced.of("0", "1"))::check)
                .hasMessage("range needs either count or step; it has neither");
        assertThatThrownBy(with("range", new EvenlySpaced("0", "1", Optional.of(3), Optional.of("0.5")))::check)
                .hasMessage("range needs either count or step; it has both");
    }

    @Test
    void parametersMustFitEachOther() {
        assertThatThrownBy(() -> uniform("5 m", "5 m").value(Quantity.LENGTH, 0.5))
                .hasMessage("'from' 5.0 must be below 'to' 5.0");
        assertThatThrownBy(() -> triangular("0", "11", "10").value(Quantity.LENGTH, 0.5))
                .hasMessage("mode 11.0 must be 0.0 to 10.0");
        assertThatThrownBy(() -> normal(Normal.of("1", "0")).value(Quantity.LENGTH, 0.5))
                .hasMessage("deviation 0.0 must be above 0");
        assertThatThrownBy(() -> uniform("5 kg", "6 m").value(Quantity.LENGTH, 0.5))
                .hasMessageContaining("from: ");
        assertThatThrownBy(Variation.NONE::check)
                .hasMessage("needs exactly one of values, range, uniform, normal and triangular; it has 0");
    }
}
