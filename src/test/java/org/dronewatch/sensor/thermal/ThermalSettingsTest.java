package org.dronewatch.sensor.thermal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.sensor.Walls.open;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.sensor.Condition;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.sensor.alarm.WeatherRate;
import org.dronewatch.sensor.optics.PictureSettings;
import org.dronewatch.world.Weather;
import org.junit.jupiter.api.Test;

/** What the settings of a thermal camera tell about it. */
class ThermalSettingsTest {
    private static final ThermalSettings CAMERA = ThermalSettings.at(new Position(0, 0, 0));
    private static final Weather DRY = new Weather(0.0, 3.0, 20_000.0, 10_000.0);
    private static final Weather WET = new Weather(8.0, 3.0, 20_000.0, 10_000.0);

    /** A rate for rain holds in rain only; noise is the camera's own, and knows no weather. */
    @Test
    void statedFalseAlarmsDependOnTheWeatherAndNoiseDoesNot() {
        FalseAlarms stated =
                new FalseAlarms(5.0, 4, 1.0, List.of(WeatherRate.of(70.0).withRain(2.0)));
        ThermalSettings counted = CAMERA.withFalseAlarms(stated);
        ThermalSettings noisy = CAMERA.withPointTargets(PointTargets.DEFAULT);

        assertThat(counted.falseAlarmRate(DRY)).contains(new FalseAlarms(5.0, 4, 1.0).rate(25.0));
        assertThat(counted.falseAlarmRate(WET)).contains(new FalseAlarms(70.0, 4, 1.0).rate(25.0));
        assertThat(counted.withPointTargets(PointTargets.DEFAULT).falseAlarmRate(WET))
                .as("a stated rate is for all causes")
                .isEqualTo(counted.falseAlarmRate(WET));
        for (Weather weather : List.of(DRY, WET)) {
            assertThat(noisy.falseAlarmRate(weather)).isPresent().isEqualTo(noisy.falseAlarmRate());
            assertThat(CAMERA.falseAlarmRate(weather)).isEmpty();
        }
    }

    @Test
    void aFalseAlarmReachesItsThresholdExactly() {
        for (double excess : new double[] {0.0, 3.0}) {
            Reading reading = CAMERA.falseReading(open(), excess);
            assertThat(reading.isDetected()).isTrue();
            assertThat(reading.value()).isEqualTo(reading.threshold()).isEqualTo(CAMERA.probability());
            assertThat(reading.unit()).isEmpty();
        }
    }

    /** The weather of a scene does not reach it: its advice names the setting that stands for it. */
    @Test
    void itsDescriptionSaysWhatItDoesNotTakeIntoAccount() {
        SensorDescription fixed = CAMERA.description();
        SensorDescription turning =
                CAMERA.withPositioner(PositionerSettings.DEFAULT).description();

        assertThat(fixed.measures()).isEqualTo("probability");
        assertThat(fixed.ignoredConditions())
                .containsOnlyKeys(Condition.VISIBILITY, Condition.RAIN, Condition.AIR)
                .allSatisfy((condition, advice) -> assertThat(advice).contains("'transmission'"));
        assertThat(Arrays.stream(ThermalSettings.class.getRecordComponents()).map(one -> one.getName()))
                .contains("transmission");
        assertThat(fixed.leavesOut()).hasSize(1).doesNotContain(PositionerSettings.LEFT_OUT);
        assertThat(turning.leavesOut()).containsAll(fixed.leavesOut()).contains(PositionerSettings.LEFT_OUT);
        assertThat(turning.ignoredConditions()).isEqualTo(fixed.ignoredConditions());
    }

    @Test
    void itsPicturesShowHeatAndNoColour() {
        Optional<PictureSettings> pictures = CAMERA.as(PictureSettings.class);

        assertThat(pictures).isPresent();
        assertThat(pictures.orElseThrow().seesColour()).isFalse();
        assertThat(CAMERA.kind()).isEqualTo("thermal");
    }
}
