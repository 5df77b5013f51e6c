package org.dronewatch.route;

import java.util.ArrayList;
import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.sensor.CrossingBlind;
import org.dronewatch.sensor.SensorSettings;

/**
 * The speeds at which a drone flies in order to pass sensors that reject some radial speeds: one a little below the
 * greatest speed at which at least 20 dB of its signal are rejected on every heading, and one in the middle of the
 * fastest rejected band above that speed, in which the drone stays while it flies straight towards the sensor or away
 * from it.
 */
final class SlowFlight {
    /** The greatest fraction of the signal that passes: -20 dB shorten the range of a radar to 32 %. */
    private static final double PASSES = 0.01;

    /** The fraction of the greatest such speed that is flown, so that no look finds the drone to be too fast. */
    private static final double BELOW = 0.99;

    /** A drone that is slower than this hovers, m/s. */
    private static final double SLOWEST = 0.1;

    /** The number of parts of the cruise speed that are tried; narrower bands may be missed. */
    private static final int PARTS = 1000;

    private static final int BISECTIONS = 40;

    private final CrossingBlind blind;
    private final double cruise;

    private SlowFlight(CrossingBlind blind, double cruise) {
        this.blind = blind;
        this.cruise = cruise;
    }

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
                .flatMap(blind -> new SlowFlight(blind, drone.speed()).speeds().stream())
                .filter(speed -> speed >= SLOWEST)
                .distinct()
                .sorted(Comparator.reverseOrder())
                .toList();
    }

    /** The speeds for one sensor: none for a band that contains the cruise speed. */
    private List<Double> speeds() {
        List<Double> speeds = new ArrayList<>();
        int part = 0;
        while (part <= PARTS && isRejected(part)) {
            part++;
        }
        if (part > 0 && part <= PARTS) {
            speeds.add(BELOW * edge(part - 1, part));
        }
        bandBelowCruise(part).ifPresent(speeds::add);
        return speeds;
    }

    /** The middle of the fastest band that is rejected between a part of the cruise speed and all of it. */
    private Optional<Double> bandBelowCruise(int from) {
        int above = PARTS;
        while (above > from && (isRejected(above) || !isRejected(above - 1))) {
            above--;
        }
        if (above <= from) {
            return Optional.empty();
        }
        int below = above - 1;
        while (isRejected(below)) {
            below--;
        }
        return Optional.of(0.5 * (edge(below + 1, below) + edge(above - 1, above)));
    }

    private boolean isRejected(int part) {
        return blind.response(cruise * part / PARTS) <= PASSES;
    }

    /** The speed at which rejection ends between two parts of the cruise speed. */
    private double edge(int rejectedPart, int passingPart) {
        double rejected = cruise * rejectedPart / PARTS;
        double passing = cruise * passingPart / PARTS;
        for (int i = 0; i < BISECTIONS; i++) {
            double middle = 0.5 * (rejected + passing);
            if (blind.response(middle) <= PASSES) {
                rejected = middle;
            } else {
                passing = middle;
            }
        }
        return rejected;
    }
}
