package org.dronewatch.sensor.alarm;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.assertj.core.api.Assertions.withinPercentage;

import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Walls;
import org.dronewatch.sensor.rf.RfSettings;
import org.dronewatch.world.Weather;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Figures that follow from a rate of false alarms. */
class FalseAlarmRateTest {
    private static final String TOO_MANY = "there must be 0 to 1000";
    private static final String NONE = "there must be at least one of each, and a rate above 0 Hz";

    @ParameterizedTest
    @CsvSource({
        "0.5, 5, 3, 4, 7200, 0.1",
        "0, 5, 1, 4, 0, 0",
        "1000, 1, 1, 0.001, 3600, 1000",
        "1e-9, 1000000000000, 1, 1000, 0.0036, 1e-21"
    })
    void anHourHasManyLooksAndAFieldManyCells(
            double perLook, long cells, int looks, double rate, double perHour, double perCell) {
        FalseAlarmRate alarms = new FalseAlarmRate(perLook, cells, looks, rate);
        assertThat(alarms.perHour()).isCloseTo(perHour, withinPercentage(1e-10));
        assertThat(alarms.perCell()).isCloseTo(perCell, withinPercentage(1e-10));
    }

    /** A Poisson number of mean ln 2 is above 0 in half of all looks; one of a tiny mean, as often as its mean. */
    @Test
    void theProbabilityIsThatOfAtLeastOneInACell() {
        assertThat(new FalseAlarmRate(4.0 * Math.log(2.0), 4, 9, 7.0).probability())
                .isCloseTo(0.5, within(1e-15));
        assertThat(new FalseAlarmRate(1.0, 1, 1, 1.0).probability()).isCloseTo(0.6321205588285577, within(1e-15));
        assertThat(new FalseAlarmRate(1e-12, 1_000_000_000, 1, 1.0).probability())
                .isCloseTo(1e-21, withinPercentage(1e-10));
        assertThat(new FalseAlarmRate(1000.0, 1, 1, 1.0).probability()).isEqualTo(1.0);
        assertThat(new FalseAlarmRate(0.0, 3, 1, 1.0).probability()).isEqualTo(0.0);
    }

    /** Counted: 2 in a look and 4 cells, so 0.5 in a cell. */
    @Test
    void aCellHasOneAsOftenAsTheProbabilityStates() {
        long seed = 20_261_130L;
        System.out.println("seed " + seed);
        RfSettings sensor = RfSettings.at(new Position(0, 0, 0)).withFalseAlarms(new FalseAlarms(7200.0, 4, 0.0));
        FalseAlarmSource source = FalseAlarmSource.of(sensor, new Weather(0.0, 0.0, 20_000.0, 5_000.0))
                .orElseThrow();
        World world = Walls.open();
        int looks = 10_000;
        int hits = 0;
        for (int i = 0; i < looks; i++) {
            boolean isHit = source.observe(world, Look.of(seed, "ear", i, i)).stream()
                    .anyMatch(one -> one.figures().get(FalseAlarmSource.CELL) == 3.0);
            hits += isHit ? 1 : 0;
        }
        double stated = sensor.falseAlarmRate().orElseThrow().probability();
        assertThat(stated).isCloseTo(1.0 - Math.exp(-0.5), within(1e-12));
        assertThat((double) hits / looks).isCloseTo(stated, within(4.0 * Math.sqrt(stated * (1.0 - stated) / looks)));
    }

    @Test
    void upToAThousandAtTheSameTimeAreAccepted() {
        assertThat(new FalseAlarmRate(1000.0, 1, 1, 1.0).perLook()).isEqualTo(1000.0);
        assertThat(new FalseAlarmRate(100.0, 1, 10, 1.0).looks()).isEqualTo(10);
        assertThat(new FalseAlarmRate(0.0, 1, Integer.MAX_VALUE, Double.MIN_VALUE).perHour())
                .isZero();
        assertThatThrownBy(() -> new FalseAlarmRate(Math.nextUp(1000.0), 1, 1, 1.0))
                .hasMessageEndingWith(TOO_MANY);
        assertThatThrownBy(() -> new FalseAlarmRate(100.0, 1, 11, 1.0))
                .hasMessage("falseAlarms: 100.0 false alarms that begin in each look, each of which lasts for 11 looks,"
                        + " amount to 1100.0 at the same time; there must be 0 to 1000");
        assertThatThrownBy(() -> new FalseAlarmRate(2.0, 1, Integer.MAX_VALUE, 1.0))
                .hasMessageEndingWith(TOO_MANY);
    }

    @ParameterizedTest
    @CsvSource({"-4.9e-324", "-1", "NaN", "Infinity", "-Infinity"})
    void whatIsNoNumberOfFalseAlarmsIsRefused(double perLook) {
        assertThatThrownBy(() -> new FalseAlarmRate(perLook, 1, 1, 1.0))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageEndingWith(TOO_MANY);
    }

    @ParameterizedTest
    @CsvSource({"0, 1, 1", "-1, 1, 1", "1, 0, 1", "1, -1, 1", "1, 1, 0", "1, 1, -1", "1, 1, NaN"})
    void withoutCellsLooksOrARateItIsRefused(long cells, int looks, double rate) {
        assertThatThrownBy(() -> new FalseAlarmRate(0.5, cells, looks, rate))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageEndingWith(NONE);
    }
}
