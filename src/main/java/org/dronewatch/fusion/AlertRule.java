package org.dronewatch.fusion;

import java.util.Collection;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/** When what the sensors observe of a drone is an alert. */
public sealed interface AlertRule {

    /**
     * Whether it is.
     *
     * @param tracks what each sensor has of the drone
     * @param time now, s
     */
    boolean holds(Collection<SensorTrack> tracks, double time);

    /** Whether a sensor has a part in it. */
    boolean counts(SensorTrack track, double time);

    /** As soon as any sensor detects it, confirmed as often as wanted. */
    record AnySensor() implements AlertRule {
        @Override
        public boolean holds(Collection<SensorTrack> tracks, double time) {
            return tracks.stream().anyMatch(track -> counts(track, time));
        }

        @Override
        public boolean counts(SensorTrack track, double time) {
            return track.isConfirmedWithin(0.0, time);
        }
    }

    /**
     * As soon as several sensors detect it, each confirmed as often as wanted.
     *
     * @param count how many, 1 to 1000
     * @param within in what time, 0 to 3600 s
     */
    record SeveralSensors(
            @In(value = Quantity.NUMBER, from = 1, to = 1000) int count,
            @In(value = Quantity.DURATION, from = 0, to = 3600) double within)
            implements AlertRule {
        /** Checks the limits. */
        public SeveralSensors {
            Limits.check(SeveralSensors.class, count, within);
        }

        /** Within 5 seconds. */
        @Defaults("count")
        public static SeveralSensors of(int count) {
            return new SeveralSensors(count, 5.0);
        }

        @Override
        public boolean holds(Collection<SensorTrack> tracks, double time) {
            return tracks.stream().filter(track -> counts(track, time)).count() >= count;
        }

        @Override
        public boolean counts(SensorTrack track, double time) {
            return track.isConfirmedWithin(within, time);
        }
    }

    /**
     * As soon as it is likely enough that at least one of the sensors detects it in its last look:
     * {@code 1 - (1-p1)(1-p2)...}. That takes their misses for independent. They are not where one hill hides the drone from
     * all of them, or one fog: then the rule promises too much. A sensor that decides by a fixed threshold counts with 0 or 1.
     *
     * @param probability from which on, above 0 and at most 1
     * @param within how long a look counts, 0 to 3600 s
     */
    record UnionOfProbabilities(
            @In(value = Quantity.RATIO, above = 0, to = 1) double probability,
            @In(value = Quantity.DURATION, from = 0, to = 3600) double within)
            implements AlertRule {
        /** Checks the limits. */
        public UnionOfProbabilities {
            Limits.check(UnionOfProbabilities.class, probability, within);
        }

        /** Looks count for 2 seconds. */
        @Defaults("probability")
        public static UnionOfProbabilities of(double probability) {
            return new UnionOfProbabilities(probability, 2.0);
        }

        @Override
        public boolean holds(Collection<SensorTrack> tracks, double time) {
            double missed = 1.0;
            for (SensorTrack track : tracks) {
                missed *= 1.0 - track.probabilityWithin(within, time);
            }
            // Rounding must not keep certain sensors from being certain together.
            return 1.0 - missed >= probability - 1e-12;
        }

        @Override
        public boolean counts(SensorTrack track, double time) {
            return track.probabilityWithin(within, time) > 0.0;
        }
    }
}
