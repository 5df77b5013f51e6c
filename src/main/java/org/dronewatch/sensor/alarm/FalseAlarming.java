package org.dronewatch.sensor.alarm;

import java.util.Optional;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.sensor.Reading;
import org.dronewatch.world.World;

/**
 * Settings of a sensor that may take something else for a drone. A capability: {@link
 * org.dronewatch.sensor.SensorSettings#as}. In a run a sensor whose rate is known reports false alarms by that rate,
 * without any effect on its looks at drones. Where one lies in the field of view is given by numbers from 0 to 1, of
 * which each is uniformly distributed over all false alarms.
 */
public interface FalseAlarming {

    /** How often it raises false alarms; empty when that is not known. */
    Optional<FalseAlarmRate> falseAlarmRate();

    /**
     * By how many of the numbers the cells of false alarms differ, 0 to 3; 0 unless overridden, for a sensor that
     * measures no direction.
     */
    default int dimensions() {
        return 0;
    }

    /**
     * Where the source of a false alarm seems to be; empty for a sensor that reports no direction.
     *
     * @param u first number, 0 to 1
     * @param v second number, 0 to 1
     * @param w third number, 0 to 1
     */
    default Optional<Sighting> falseSighting(double u, double v, double w) {
        return Optional.empty();
    }

    /**
     * What a false alarm measures: a value that reaches the threshold.
     *
     * @param world the site
     * @param excess 0 or more, exponentially distributed with mean 1: by how much noise exceeds a threshold
     */
    Reading falseReading(World world, double excess);

    /**
     * Where the bearings of false alarms lie; empty for a sensor that measures none, and for one whose bearings are not
     * known beforehand, such as one on a positioner.
     */
    default Optional<AzimuthSpan> falseBearings() {
        return Optional.empty();
    }

    /** Settings that state a rate as such. */
    interface Stated extends FalseAlarming {
        /** How often it raises false alarms; empty when that is not known. */
        Optional<FalseAlarms> falseAlarms();

        /** Looks per second, Hz. */
        double rate();

        @Override
        default Optional<FalseAlarmRate> falseAlarmRate() {
            return falseAlarms().map(known -> known.rate(rate()));
        }
    }
}
