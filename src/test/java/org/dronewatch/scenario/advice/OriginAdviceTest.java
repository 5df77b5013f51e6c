package org.dronewatch.scenario.advice;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geo.Origin;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class OriginAdviceTest {
    private static List<String> advice(double latitude, double longitude) {
        List<String> lines = new ArrayList<>();
        new OriginAdvice(Origin.at(latitude, longitude)).giveTo(lines::add);
        return lines;
    }

    /** Quito, in degrees that are taken as radians. */
    @Test
    void whatWasWrittenWithoutAUnitIsDoubted() {
        assertThat(advice(-0.18, Math.toRadians(-78.47)))
                .containsExactly("world.origin.latitude is -10.31324 deg (-0.18 rad); for degrees, write -0.18 deg");
        assertThat(advice(Math.toRadians(51.4779), -0.0015))
                .containsExactly(
                        "world.origin.longitude is -0.08594367 deg (-0.0015 rad); for degrees, write -0.0015 deg");
    }

    @ParameterizedTest
    @CsvSource({"43.7314, 7.4202", "0, 0", "-0.18, -78.47", "90, 180", "45, 60", "51.477928, -0.001545"})
    void degreesAreNot(double latitude, double longitude) {
        assertThat(advice(Math.toRadians(latitude), Math.toRadians(longitude))).isEmpty();
    }
}
