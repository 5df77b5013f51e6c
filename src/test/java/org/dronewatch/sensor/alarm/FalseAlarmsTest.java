package org.dronewatch.sensor.alarm;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.dronewatch.world.Weather;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A rate of false alarms as a user states it. */
class FalseAlarmsTest {
    private static final List<WeatherRate> RAIN = List.of(WeatherRate.of(40).withRain(2));
    private static final FalseAlarms STATED = new FalseAlarms(20, 7, 3.5, RAIN);

    @Test
    void oneChangeLeavesEverythingElse() {
        assertThat(STATED.withCells(9)).isEqualTo(new FalseAlarms(20, 9, 3.5, RAIN));
        assertThat(STATED.withDuration(0)).isEqualTo(new FalseAlarms(20, 7, 0, RAIN));
        assertThat(STATED.withWeather(List.of())).isEqualTo(new FalseAlarms(20, 7, 3.5));
        assertThat(STATED.in(new Weather(2, 0, 20_000, 5_000))).isEqualTo(new FalseAlarms(40, 7, 3.5));
        assertThat(STATED.in(new Weather(Math.nextDown(2.0), 0, 20_000, 5_000))).isEqualTo(new FalseAlarms(20, 7, 3.5));
    }

    /** A duration takes up whole looks, at least one; 0.07 s at 100 Hz is 7.000000000000001 looks, which are 7. */
    @ParameterizedTest
    @CsvSource({
        "0, 4, 1",
        "0.249, 4, 1",
        "0.25, 4, 1",
        "0.2501, 4, 2",
        "0.5, 4, 2",
        "0.07, 100, 7",
        "0.0700001, 100, 8",
        "600, 1000, 600000",
        "600, 0.001, 1"
    })
    void aDurationIsAWholeNumberOfLooks(double duration, double rate, int looks) {
        FalseAlarmRate result = new FalseAlarms(1, 5, duration).rate(rate);
        assertThat(result.looks()).isEqualTo(looks);
        assertThat(result.cells()).isEqualTo(5);
        assertThat(result.rate()).isEqualTo(rate);
    }

    @Test
    void ofEqualEntriesAllButTheFirstMakeNoDifference() {
        WeatherRate wet = WeatherRate.of(12).withRain(2);
        assertThat(FalseAlarms.of(5).withWeather(List.of(wet, wet, wet)).advice())
                .containsExactly(
                        "falseAlarms.weather.1 makes no difference: whenever it applies, so does weather.0, whose rate"
                                + " is at least as high",
                        "falseAlarms.weather.2 makes no difference: whenever it applies, so does weather.0, whose rate"
                                + " is at least as high");
    }

    /** Of two equal rates, the one that applies less often makes no difference, wherever it stands. */
    @Test
    void ofEqualRatesTheNarrowerMakesNoDifference() {
        WeatherRate wide = WeatherRate.of(12).withRain(1);
        WeatherRate narrow = WeatherRate.of(12).withRain(2);
        assertThat(FalseAlarms.of(5).withWeather(List.of(wide, narrow)).advice())
                .singleElement()
                .asString()
                .startsWith("falseAlarms.weather.1 makes no difference: whenever it applies, so does weather.0,");
        assertThat(FalseAlarms.of(5).withWeather(List.of(narrow, wide)).advice())
                .singleElement()
                .asString()
                .startsWith("falseAlarms.weather.0 makes no difference: whenever it applies, so does weather.1,");
    }

    /** A narrower entry with a higher rate makes a difference, even by the least. */
    @Test
    void theNarrowerMakesADifferenceWhereItsRateIsHigher() {
        WeatherRate wide = WeatherRate.of(12).withRain(1);
        WeatherRate narrow = WeatherRate.of(Math.nextUp(12.0)).withRain(2);
        assertThat(FalseAlarms.of(5).withWeather(List.of(wide, narrow)).advice())
                .isEmpty();
        assertThat(FalseAlarms.of(5).withWeather(List.of(narrow, wide)).advice())
                .isEmpty();
    }
}
