package org.dronewatch.fusion;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;

/** A rule that determines when the sensors' looks at a contact raise an alert. */
public sealed interface AlertRule {

    /**
     * The sensors whose looks justify an alert now; empty if there is no alert.
     *
     * @param tracks the record of each sensor's looks at the contact
     * @param time the present time, s
     */
    List<SensorTrack> carriers(Collection<SensorTrack> tracks, double time);

    /** An alert as soon as any sensor detects the drone, with the confirmation required. */
    record AnySensor() implements AlertRule {
        @Override
        public List<SensorTrack> carriers(Collection<SensorTrack> tracks, double time) {
            return tracks.stream()
                    .filter(track -> track.isConfirmedWithin(0.0, time))
                    .toList();
        }
    }

    /**
     * An alert as soon as several sensors detect the drone, each with the confirmation required.
     *
     * @param count number of sensors, 1 to 1000
     * @param within time within which they must detect it, 0 to 3600 s
     * @param gate maximum difference between the bearings of two sensors' false alarms that count as one drone, 0 to
     *     180 degrees, rad; a sensor that measures no bearing agrees with any. The gate has no effect on drones
     */
    record SeveralSensors(
            @In(value = Quantity.NUMBER, from = 1, to = 1000) int count,
            @In(value = Quantity.DURATION, from = 0, to = 3600) double within,
            @Minor @In(value = Quantity.ANGLE, from = 0, to = Math.PI) double gate)
            implements AlertRule {
        private static final double USUAL_GATE = Math.toRadians(10.0);

        /** Checks the limits. */
        public SeveralSensors {
            Limits.check(SeveralSensors.class, count, within, gate);
        }

        /**
         * A rule with a gate of 10 degrees, which is assumed: the difference between bearings from sensors 50 m apart
         * to a drone at 300 m.
         */
        public SeveralSensors(int count, double within) {
            this(count, within, USUAL_GATE);
        }

        /** A rule with a time window of 5 seconds. */
        @Defaults("count")
        public static SeveralSensors of(int count) {
            return new SeveralSensors(count, 5.0);
        }

        /** This rule with another gate, rad. */
        public SeveralSensors withGate(double angle) {
            return SettingsForm.with(this, "gate", angle);
        }

        @Override
        public List<SensorTrack> carriers(Collection<SensorTrack> tracks, double time) {
            List<SensorTrack> confirmed = tracks.stream()
                    .filter(track -> track.isConfirmedWithin(within, time))
                    .toList();
            return confirmed.size() >= count ? confirmed : List.of();
        }
    }

    /**
     * An alert as soon as {@code 1 - (1-p1)(1-p2)...}, the probability that at least one of the sensors detects the
     * drone in its last look, is high enough. This assumes that the sensors' misses are independent; if one hill or one
     * bank of fog hides the drone from all of them, the rule is too optimistic. The probability of a sensor with a
     * fixed threshold is 0 or 1.
     *
     * @param probability the combined probability that raises the alert, above 0 and at most 1
     * @param within how long a look remains valid, 0 to 3600 s
     */
    record UnionOfProbabilities(
            @In(value = Quantity.RATIO, above = 0, to = 1) double probability,
            @In(value = Quantity.DURATION, from = 0, to = 3600) double within)
            implements AlertRule {
        /** Checks the limits. */
        public UnionOfProbabilities {
            Limits.check(UnionOfProbabilities.class, probability, within);
        }

        /** A rule in which looks remain valid for 2 seconds. */
        @Defaults("probability")
        public static UnionOfProbabilities of(double probability) {
            return new UnionOfProbabilities(probability, 2.0);
        }

        /** {@inheritDoc} Those with the highest probabilities come first; there are as many as necessary. */
        @Override
        public List<SensorTrack> carriers(Collection<SensorTrack> tracks, double time) {
            List<SensorTrack> likeliest = new ArrayList<>(tracks);
            likeliest.sort(Comparator.comparingDouble(track -> -track.probabilityWithin(within, time)));
            double missed = 1.0;
            for (int i = 0; i < likeliest.size(); i++) {
                missed *= 1.0 - likeliest.get(i).probabilityWithin(within, time);
                // Rounding must not keep certain sensors from being certain together.
                if (1.0 - missed >= probability - 1e-12) {
                    return List.copyOf(likeliest.subList(0, i + 1));
                }
            }
            return List.of();
        }
    }
}
