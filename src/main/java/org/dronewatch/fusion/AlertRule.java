package org.dronewatch.fusion;

import java.util.List;
import java.util.Optional;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Minor;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.tracking.ConfirmedContact;
import org.dronewatch.tracking.ContactMatcher;

/** A rule that determines when there is an alert for a contact. */
public sealed interface AlertRule
        permits AlertRule.SeveralSensors, AlertRule.AnySensor, AlertRule.UnionOfProbabilities {

    /** How the sensors' looks raise an alert; empty for a rule that forecasts alerts instead ({@link ForecastLog}). */
    default Optional<Decision> decision() {
        return Optional.empty();
    }

    /** A rule that a system can follow, since it decides on the basis of measurements alone. */
    interface Decision {
        /**
         * The confirmations that justify an alert now; empty if there is no alert.
         *
         * @param confirmed the most recent confirmation of an object by each sensor that has confirmed it
         * @param time the present time, s
         */
        List<ConfirmedContact> carriers(List<ConfirmedContact> confirmed, double time);

        /** How contacts of different sensors are matched for this rule. */
        default ContactMatcher matcher(ContactMatcher.Source association) {
            return ContactMatcher.NONE;
        }
    }

    /** An alert as soon as any sensor detects the drone, with the required confirmation. */
    record AnySensor() implements AlertRule, Decision {
        @Override
        public Optional<Decision> decision() {
            return Optional.of(this);
        }

        @Override
        public List<ConfirmedContact> carriers(List<ConfirmedContact> confirmed, double time) {
            return confirmed.stream().filter(one -> one.time() >= time).toList();
        }
    }

    /**
     * An alert as soon as several sensors detect the drone, each with the required confirmation.
     *
     * @param count number of sensors, 1 to 1000
     * @param within time within which these sensors must detect the drone, 0 to 3600 s
     * @param gate maximum difference between the bearings of two sensors' false alarms that count as one drone, 0 to
     *     pi rad (180 degrees); a sensor that measures no bearing agrees with any. The gate has no effect on drones
     */
    record SeveralSensors(
            @In(value = Quantity.NUMBER, from = 1, to = 1000) int count,
            @In(value = Quantity.DURATION, from = 0, to = 3600) double within,
            @Minor @In(value = Quantity.ANGLE, from = 0, to = Math.PI) double gate)
            implements AlertRule, Decision {
        private static final double USUAL_GATE = Math.toRadians(10.0);

        /** Checks the limits. */
        public SeveralSensors {
            Limits.check(SeveralSensors.class, count, within, gate);
        }

        /**
         * A rule with an assumed gate of 10 degrees: about the difference between the bearings to a drone at 300 m from
         * two sensors 50 m apart.
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
        public Optional<Decision> decision() {
            return Optional.of(this);
        }

        @Override
        public List<ConfirmedContact> carriers(List<ConfirmedContact> confirmed, double time) {
            List<ConfirmedContact> recent = confirmed.stream()
                    .filter(one -> one.time() >= time - within)
                    .toList();
            return recent.size() >= count ? recent : List.of();
        }

        @Override
        public ContactMatcher matcher(ContactMatcher.Source association) {
            return association.matcher(gate, within);
        }
    }

    /**
     * An alert as soon as the probability that at least one of the sensors detects the drone in its most recent look is
     * high enough; for three sensors whose looks have the detection probabilities p1, p2 and p3, it is {@code 1 -
     * (1-p1)(1-p2)(1-p3)}. This rule is a forecast for scoring ({@link ForecastLog}), not a rule that a system could
     * follow: looks that detect nothing count with their probabilities, which only the simulation knows. It assumes
     * that the sensors' misses are independent; if one hill or one bank of fog hides the drone from all of them, it is
     * too optimistic. The probability of a sensor with a fixed threshold is 0 or 1, and that of a false alarm is 1.
     *
     * @param probability the combined probability that raises the alert, above 0 and at most 1
     * @param within time for which a look remains valid, 0 to 3600 s
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
    }
}
