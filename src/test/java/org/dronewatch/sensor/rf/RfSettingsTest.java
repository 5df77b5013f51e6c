package org.dronewatch.sensor.rf;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.drone.RadioLink;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Explanation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Thresholded;
import org.dronewatch.sensor.Walls;
import org.dronewatch.sensor.alarm.FalseAlarms;
import org.dronewatch.sensor.radio.AntennaPattern;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** What a receiver is set to, and which links it hears. */
class RfSettingsTest {
    private static final Position PLACE = new Position(1, 2, 3);

    private static RfSettings receiver() {
        return RfSettings.at(PLACE);
    }

    /** 10 MHz and 6 dB: 10 lg(k 290 K 1 Hz / 1 mW) = -173.975 dBm, and 70 dB and 6 dB more. */
    @Test
    void theReceiverThatIsMeantUnlessSet() {
        RfSettings receiver = receiver();
        assertThat(receiver.position()).isEqualTo(PLACE);
        assertThat(receiver.rate()).isEqualTo(1.0);
        assertThat(receiver.minFrequency()).isEqualTo(400e6);
        assertThat(receiver.maxFrequency()).isEqualTo(6e9);
        assertThat(receiver.threshold()).isEqualTo(6.0);
        assertThat(receiver.noise()).isCloseTo(-97.975, within(1e-3));
        assertThat(receiver.recognised()).containsExactly(RadioLink.Emission.DEDICATED, RadioLink.Emission.WLAN);
        assertThat(receiver.falseAlarmRate()).isEmpty();
    }

    @Test
    void oneChangeLeavesEverythingElse() {
        Position elsewhere = new Position(-4, 5, -6);
        FalseAlarms often = FalseAlarms.of(30);
        assertThat(receiver().withPosition(elsewhere)).isEqualTo(RfSettings.at(elsewhere));
        assertThat(receiver().withThreshold(9.5)).isEqualTo(SettingsForm.with(receiver(), "threshold", 9.5));
        assertThat(receiver().withThreshold(9.5).withThreshold(6.0)).isEqualTo(receiver());
        assertThat(receiver().withFalseAlarms(often).falseAlarms()).contains(often);
        assertThat(receiver().withFalseAlarms(often).withThreshold(7).withPosition(elsewhere))
                .isEqualTo(RfSettings.at(elsewhere).withThreshold(7).withFalseAlarms(often));
    }

    @Test
    void itMattersWhereItPointsOnlyWithABeam() {
        RfSettings beam = receiver().withBeam(AntennaPattern.of(1.0, 0.5));
        assertThat(receiver().as(Aimed.class).orElseThrow().isDirectional()).isFalse();
        assertThat(beam.as(Aimed.class).orElseThrow().isDirectional()).isTrue();
    }

    /** All values of the scale may be set, and none beyond. */
    @Test
    void theScaleOfTheThresholdIsThatOfTheSetting() {
        Thresholded.Scale scale = receiver().thresholdScale();
        assertThat(scale.quantity()).isEqualTo(Quantity.LEVEL);
        assertThat(scale.value(0)).isEqualTo(-50.0);
        assertThat(scale.value(scale.last())).isEqualTo(100.0);
        for (double value : new double[] {scale.lowest(), scale.highest(), scale.value(56_000_001)}) {
            assertThat(SettingsForm.with(receiver(), scale.setting(), value))
                    .isEqualTo(receiver().withThreshold(value));
        }
        assertThatThrownBy(() -> receiver().withThreshold(scale.lowest() - scale.step()))
                .hasMessageStartingWith("threshold");
        assertThatThrownBy(() -> receiver().withThreshold(scale.highest() + scale.step()))
                .hasMessageStartingWith("threshold");
    }

    @Test
    void carriersAtBothLimitsAreHeard() {
        RfSettings receiver = receiver().withFrequencies(2.4e9, 2.5e9);
        for (double carrier : new double[] {2.4e9, 2.45e9, 2.5e9}) {
            assertThat(receiver.hears(RadioLink.DEFAULT.withFrequency(carrier))).isTrue();
        }
        for (double carrier : new double[] {Math.nextDown(2.4e9), Math.nextUp(2.5e9), 1e6, 1e11}) {
            assertThat(receiver.hears(RadioLink.DEFAULT.withFrequency(carrier))).isFalse();
        }
    }

    /** The limit that a carrier violates, and none for a link whose silence has another reason. */
    @Test
    void aSilentCarrierNamesTheLimitThatItViolates() {
        RfSettings receiver = receiver().withFrequencies(2.4e9, 2.5e9);
        RadioLink link = RadioLink.DEFAULT;
        assertThat(receiver.silence(link.withFrequency(Math.nextDown(2.4e9))))
                .isEqualTo(Explanation.beyond(Cause.SILENT, 2.4e9));
        assertThat(receiver.silence(link.withFrequency(Math.nextUp(2.5e9))))
                .isEqualTo(Explanation.beyond(Cause.SILENT, 2.5e9));
        RadioLink phone = link.withEmission(RadioLink.Emission.CELLULAR);
        assertThat(receiver.silence(phone.withFrequency(2.4e9))).isEqualTo(Explanation.of(Cause.SILENT));
        assertThat(receiver.silence(phone.withFrequency(2.5e9))).isEqualTo(Explanation.of(Cause.SILENT));
        assertThat(receiver.silence(link.withFrequency(1e9).withControl(RadioLink.Control.FIBRE)))
                .isEqualTo(Explanation.of(Cause.SILENT));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0.0, 1e-300, 1.0, 40.0})
    void aFalseAlarmJustReachesTheThreshold(double excess) {
        Reading reading = receiver().withThreshold(-3.5).falseReading(Walls.open(), excess);
        assertThat(reading).isEqualTo(new Reading(-3.5, -3.5, "dB"));
        assertThat(reading.isDetected()).isTrue();
    }

    @Test
    void reportsCallItByItsKindAndItsQuantity() {
        assertThat(receiver().kind()).isEqualTo("rf");
        assertThat(receiver().create().settings()).isEqualTo(receiver());
        assertThat(receiver().description().measures()).isEqualTo("signal-to-noise ratio");
        assertThat(receiver().description().weakness()).isEqualTo("signal too weak");
        assertThat(receiver().description().leavesOut())
                .singleElement()
                .asString()
                .contains("reflections from walls are not modelled");
        assertThat(receiver().description().ignoredConditions()).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({"2.4e9, 2.4e9", "2.5e9, 2.4e9"})
    void frequenciesInTheWrongOrderAreRefused(double from, double to) {
        assertThatThrownBy(() -> receiver().withFrequencies(from, to))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining(" Hz must be below maxFrequency 2.4E9 Hz");
        assertThat(receiver().withFrequencies(Math.nextDown(to), to).hears(RadioLink.DEFAULT))
                .isTrue();
    }

    /** A change of the caller's list does not reach the settings. */
    @Test
    void whatIsRecognisedIsCopied() {
        List<RadioLink.Emission> kinds = new ArrayList<>(List.of(RadioLink.Emission.WLAN));
        RfSettings receiver = receiver().withRecognised(kinds);
        kinds.clear();
        assertThat(receiver.recognised()).containsExactly(RadioLink.Emission.WLAN);
    }
}
