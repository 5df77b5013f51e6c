package org.dronewatch.route;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.sensor.CrossingBlind;
import org.dronewatch.sensor.SensorSettings;

/**
 * The speeds at which a drone flies that wants to pass sensors which reject low radial speeds: a little below the
 * greatest one at which at least 20 dB of its signal are rejected on every heading.
 */
final class SlowFlight {
    /** The greatest fraction of the signal that passes: -20 dB shorten the range of a radar to 32 %. */
    private static final double PASSES = 0.01;

    /** The fraction of the greatest such speed that is flown, so that no look finds the drone to be too fast. */
    private static final double BELOW = 0.99;

    /** Whoever is still slower hovers, m/s. */
    private static final double SLOWEST = 0.1;

    /** The number of parts of the cruise speed that are tried; rejection may set in again at higher speeds. */
    private static final int PARTS = 1000;

    private static final int BISECTIONS = 40;

    private SlowFlight() {}

    /**
     * The speeds, one for all sensors that reject the same speeds.
     *
     * @return the fastest first, m/s; none if the drone cannot hover, or there is no such sensor
     */
    static List<Double> speeds(DroneSettings drone, Collection<SensorSettings<?>> sensors) {
        if (!drone.flightLimits().hover()) {
            return List.of();
        }
        return sensors.stream()
                .map(sensor -> sensor.as(CrossingBlind.class))
                .flatMap(Optional::stream)
                .map(blind -> below(blind, drone.speed()))
                .flatMapToDouble(OptionalDouble::stream)
                .boxed()
                .distinct()
                .sorted(Comparator.reverseOrder())
                .toList();
    }

    /** The speed for one sensor; empty if it sees slow drones, or rejects all speeds up to the cruise speed. */
    private static OptionalDouble below(CrossingBlind blind, double cruise) {
        int part = 1;
        while (part <= PARTS && blind.response(cruise * part / PARTS) <= PASSES) {
            part++;
        }
        if (part > PARTS || blind.response(0.0) > PASSES) {
            return OptionalDouble.empty();
        }
        double low = cruise * (part - 1) / PARTS;
        double high = cruise * part / PARTS;
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = 0.5 * (low + high);
            if (blind.response(middle) <= PASSES) {
                low = middle;
            } else {
                high = middle;
            }
        }
        return BELOW * low < SLOWEST ? OptionalDouble.empty() : OptionalDouble.of(BELOW * low);
    }
}
