package org.dronewatch.scenario.advice;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.world.Light;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class LightAdviceTest {
    private static List<String> advice(double degrees, double lux) {
        List<String> lines = new ArrayList<>();
        Light light = Light.DAY.withIlluminance(lux).withSun(new Light.Sun(1.0, Math.toRadians(degrees)));
        new LightAdvice(light).giveTo(lines::add);
        return lines;
    }

    @Test
    void lightThatNoWeatherBringsIsNamedWithItsRange() {
        assertThat(advice(-20, 60_000))
                .containsExactly(
                        "world.light.illuminance 60000 lx is implausible with the sun 20.0 degrees below the horizon: the"
                                + " natural range at this elevation is 1e-5 lx to 0.27 lx; the illuminance and the"
                                + " sun's elevation are used as stated");
        assertThat(advice(60, 1))
                .containsExactly(
                        "world.light.illuminance 1 lx is implausible with the sun 60.0 degrees above the horizon: the"
                                + " natural range at this elevation is 510 lx to 150000 lx; the illuminance and the"
                                + " sun's elevation are used as stated");
    }

    /** Sunshine, thick cloud, dusk, full moon and starlight. */
    @ParameterizedTest
    @CsvSource({
        "60, 100000",
        "40, 60000",
        "40, 1000",
        "5, 5000",
        "-2, 20",
        "-3, 120",
        "-6, 4",
        "-18, 0.25",
        "-30, 0.001"
    })
    void lightThatOccursIsLeftAlone(double degrees, double lux) {
        assertThat(advice(degrees, lux)).isEmpty();
    }

    @Test
    void withoutASunThereIsNothingToCompare() {
        List<String> lines = new ArrayList<>();
        new LightAdvice(Light.DAY.withIlluminance(1e-5)).giveTo(lines::add);
        assertThat(lines).isEmpty();
    }
}
