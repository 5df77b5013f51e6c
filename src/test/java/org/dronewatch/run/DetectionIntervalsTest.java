package org.dronewatch.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.run.DetectionIntervals.Interval;
import org.dronewatch.sensor.GroundTruth;
import org.dronewatch.sensor.LookId;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.junit.jupiter.api.Test;

class DetectionIntervalsTest {
    private static DetectionEvent event(String sensor, String drone, boolean gained, double emission, double arrival) {
        return new DetectionEvent(
                0,
                gained,
                new Observation(
                        new LookId(sensor, "acoustic", 0, arrival),
                        new GroundTruth(drone, 50, emission),
                        new Reading(gained ? 9 : 1, 5, "dB"),
                        Map.of(),
                        Optional.empty()));
    }

    private static DetectionEvent event(String sensor, String drone, boolean gained, double time) {
        return event(sensor, drone, gained, time, time);
    }

    /** One drone from 1 to 3 s and from 6 s on, another from 2 to 5 s; another sensor has one from 4 to 4.5 s. */
    private static final DetectionIntervals INTERVALS = DetectionIntervals.of(List.of(
            event("ear", "one", true, 1),
            event("ear", "two", true, 2),
            event("ear", "one", false, 3),
            event("eye", "two", true, 4),
            event("eye", "two", false, 4.5),
            event("ear", "two", false, 5),
            event("ear", "one", true, 6)));

    @Test
    void aSensorHoldsAnyDroneFromTheFirstGainToTheLastLoss() {
        assertThat(INTERVALS.ofSensor("ear", 8)).containsExactly(new Interval(1, 5), new Interval(6, 8));
        assertThat(INTERVALS.ofSensor("eye", 8)).containsExactly(new Interval(4, 4.5));
        assertThat(INTERVALS.ofSensor("nose", 8)).isEmpty();
    }

    @Test
    void theTimeForWhichADroneIsDetectedEndsWithTheRun() {
        assertThat(INTERVALS.detectedFor("ear", "one", 8)).isEqualTo(4.0);
        assertThat(INTERVALS.detectedFor("ear", "one", 2.5)).isEqualTo(1.5);
        assertThat(INTERVALS.detectedFor("eye", "two", 8)).isEqualTo(0.5);
        assertThat(INTERVALS.detectedFor("eye", "one", 8)).isZero();
    }

    @Test
    void aDroneIsDetectedFromItsGainUntilJustBeforeItsLoss() {
        assertThat(INTERVALS.isDetected("ear", "one", 0.999)).isFalse();
        assertThat(INTERVALS.isDetected("ear", "one", 1)).isTrue();
        assertThat(INTERVALS.isDetected("ear", "one", 2.999)).isTrue();
        assertThat(INTERVALS.isDetected("ear", "one", 3)).isFalse();
        assertThat(INTERVALS.isDetected("ear", "two", 3)).isTrue();
        assertThat(INTERVALS.isDetected("ear", "one", 1e9)).isTrue();
        assertThat(INTERVALS.isDetected("eye", "one", 4.2)).isFalse();
    }

    @Test
    void onlyWhatIsNotGainedAgainIsLostForGood() {
        assertThat(INTERVALS.lostForGood("ear", "one")).isEmpty();
        assertThat(INTERVALS.lostForGood("ear", "two").orElseThrow().arrival()).isEqualTo(5);
        assertThat(INTERVALS.lostForGood("eye", "one")).isEmpty();
    }

    @Test
    void soundCountsFromItsArrival() {
        DetectionIntervals late = DetectionIntervals.of(List.of(event("ear", "one", true, 1, 3)));

        assertThat(late.isDetected("ear", "one", 2.9)).isFalse();
        assertThat(late.isDetected("ear", "one", 3)).isTrue();
        assertThat(late.ofSensor("ear", 4)).containsExactly(new Interval(3, 4));
    }
}
