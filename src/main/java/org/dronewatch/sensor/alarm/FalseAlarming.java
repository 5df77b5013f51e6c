package org.dronewatch.sensor.alarm;

import java.util.Optional;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Reading;
import org.dronewatch.world.Weather;
import org.dronewatch.world.World;

/**
 * Settings of a sensor that may raise false alarms. This is a capability, queried by {@link
 * org.dronewatch.sensor.SensorSettings#as}. In a run, a sensor whose rate is known reports false alarms at that rate,
 * without any effect on its looks at drones. The position of a false alarm in the field of view is given by numbers
 * that are uniformly distributed from 0 to 1.
 */
public interface FalseAlarming {

    /**
     * The rate of the sensor's false alarms in weather for which no other rate is stated; empty when it is not known.
     */
    Optional<FalseAlarmRate> falseAlarmRate();

    /**
     * The rate of the sensor's false alarms in given weather: the same in all weather unless overridden; empty when it
     * is not known.
     */
    default Optional<FalseAlarmRate> falseAlarmRate(Weather weather) {
        return falseAlarmRate();
    }

    /**
     * The number of random numbers, each from 0 to 1, that determine the cell of a false alarm, 0 to 3; 0 unless
     * overridden, for a sensor that measures no direction.
     */
    default int dimensions() {
        return 0;
    }

    /**
     * The sighting of a false alarm; empty for a sensor that reports no direction.
     *
     * @param u first number, 0 to 1
     * @param v second number, 0 to 1
     * @param w third number, 0 to 1
     */
    default Optional<Sighting> falseSighting(double u, double v, double w) {
        return Optional.empty();
    }

    /**
     * The reading of a false alarm: a value that reaches the threshold.
     *
     * @param world the site
     * @param excess excess of the noise power over the threshold, divided by the mean noise power: 0 or more,
     *     exponentially distributed with mean 1
     */
    Reading falseReading(World world, double excess);

    /**
     * The bearings of false alarms; empty for a sensor that measures none, and for one whose bearings are not known
     * beforehand, such as one on a positioner.
     */
    default Optional<AzimuthSpan> falseBearings() {
        return Optional.empty();
    }

    /** Settings that state a rate directly. */
    interface Stated extends FalseAlarming {
        /** The rate of the sensor's false alarms; empty when it is not known. */
        Optional<FalseAlarms> falseAlarms();

        /** Looks per second, Hz. */
        double rate();

        @Override
        default Optional<FalseAlarmRate> falseAlarmRate() {
            return falseAlarms().map(known -> known.rate(rate()));
        }

        @Override
        default Optional<FalseAlarmRate> falseAlarmRate(Weather weather) {
            return falseAlarms().map(known -> known.in(weather).rate(rate()));
        }
    }
}
