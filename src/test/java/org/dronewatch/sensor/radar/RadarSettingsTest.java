package org.dronewatch.sensor.radar;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.CrossingBlind;
import org.dronewatch.sensor.alarm.NoiseAlarming;
import org.dronewatch.sensor.radar.DopplerFilter.HighPass;
import org.dronewatch.sensor.radar.LinkBudget.Hardware;
import org.dronewatch.sensor.radar.RadarDetection.Chance;
import org.dronewatch.sensor.radar.Rain.Polarisation;
import org.dronewatch.sensor.radar.SurfaceReflectivity.ConstantGamma;
import org.junit.jupiter.api.Test;

/** What the settings of a radar say of it, apart from its looks. */
class RadarSettingsTest {
    private static RadarSettings radar() {
        return RadarSettings.at(new Position(0, 0, 5), new Hardware(4, 33, 0.02, 10e6, 5, 6));
    }

    @Test
    void oneSettingIsChangedAndTheOthersStay() {
        RadarSettings moved = radar().withPosition(new Position(1, 2, 3));
        assertThat(moved.position()).isEqualTo(new Position(1, 2, 3));
        assertThat(moved.withPosition(radar().position())).isEqualTo(radar());
        RadarSettings fast = radar().withSpeeds(3, 50);
        assertThat(fast.minSpeed()).isEqualTo(3.0);
        assertThat(fast.maxSpeed()).isEqualTo(50.0);
        assertThat(fast.withSpeeds(1, 200)).isEqualTo(radar());
        RadarSettings higher = radar().withWave(24e9, Polarisation.VERTICAL);
        assertThat(higher.frequency()).isEqualTo(24e9);
        assertThat(higher.polarisation()).isEqualTo(Polarisation.VERTICAL);
        assertThat(higher.withWave(10e9, Polarisation.HORIZONTAL)).isEqualTo(radar());
        Clutter clutter = Clutter.of(new ConstantGamma(-13), 20);
        assertThat(clutter.withImprovement(35)).isEqualTo(Clutter.of(new ConstantGamma(-13), 35));
        assertThat(radar().create().settings()).isEqualTo(radar());
        assertThat(radar().kind()).isEqualTo("radar");
    }

    @Test
    void itIsDirectionalUnlessItScansTheFullCircle() {
        assertThat(radar().withFieldOfView(2 * Math.PI, 0.5).isDirectional()).isFalse();
        assertThat(radar().withFieldOfView(2 * Math.PI - 0.01, 0.5).isDirectional())
                .isTrue();
    }

    /** Whatever is within the limits of radial speed, themselves included, passes in full; a notch takes its part. */
    @Test
    void theResponseIsThatOfTheLimitsAndOfTheNotch() {
        RadarSettings hard = radar().withSpeeds(2, 40);
        for (double passed : new double[] {2, -2, 10, -40, 40}) {
            assertThat(hard.response(passed)).as("%f m/s", passed).isEqualTo(1.0);
        }
        for (double rejected : new double[] {0, 1.999, -1.999, 40.001, -40.001}) {
            assertThat(hard.response(rejected)).as("%f m/s", rejected).isZero();
        }
        RadarSettings notched = hard.withNotch(new HighPass(5, 1));
        assertThat(notched.response(0)).isZero();
        assertThat(notched.response(-5)).isCloseTo(0.5, within(1e-12));
        assertThat(notched.response(1)).isCloseTo(1.0 / 26.0, within(1e-12));
        assertThat(notched.response(41)).isZero();
    }

    @Test
    void onlyARadarThatRejectsSlowEchoesIsBlindToCrossingDrones() {
        RadarSettings any = radar().withSpeeds(0, 200);
        assertThat(any.as(CrossingBlind.class)).isEmpty();
        assertThat(any.as(Aimed.class)).containsSame(any);
        assertThat(radar().as(CrossingBlind.class)).contains(radar());
        RadarSettings notched = any.withNotch(new HighPass(2, 2));
        assertThat(notched.as(CrossingBlind.class)).containsSame(notched);
        assertThat(any.as(NoiseAlarming.class)).containsSame(any);
        assertThat(any.as(List.class)).isEmpty();
    }

    /** The setting is named that would be refused, or ignored, in the other case. */
    @Test
    void theProbabilityOfAFalseAlarmIsSetWhereTheDetectionIsByChance() {
        assertThat(radar().falseAlarmSetting()).isEqualTo("falseAlarms.probability");
        assertThat(radar().withDetection(Chance.DEFAULT).falseAlarmSetting()).isEqualTo("detection.falseAlarm");
    }

    @Test
    void reportsNameTheRatioAndLeaveOutOnlyWhatIsNotSet() {
        RadarSettings bare = radar();
        assertThat(bare.description().measures()).isEqualTo("signal-to-noise ratio");
        assertThat(bare.description().weakness()).isEqualTo("echo too weak");
        assertThat(bare.description().leavesOut())
                .hasSize(3)
                .anyMatch(text -> text.contains("'clutter'"))
                .anyMatch(text -> text.contains("'notch'"))
                .anyMatch(text -> text.contains("birds"));
        RadarSettings notched = bare.withNotch(new HighPass(2, 2));
        assertThat(notched.description().leavesOut()).hasSize(2).noneMatch(text -> text.contains("'notch'"));
        RadarSettings cluttered =
                bare.withBeam(BeamPattern.of(0.05, 0.2)).withClutter(Clutter.of(new ConstantGamma(-13), 20));
        assertThat(cluttered.description().measures()).isEqualTo("signal-to-clutter-plus-noise ratio");
        assertThat(cluttered.description().leavesOut()).hasSize(2).noneMatch(text -> text.contains("'clutter'"));
    }
}
