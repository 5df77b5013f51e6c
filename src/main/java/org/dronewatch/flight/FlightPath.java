package org.dronewatch.flight;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/**
 * A path of a drone in space and time. Immutable, except for {@link SteeredFlight}, which any thread may nevertheless
 * query. Once returned, the state at a time never changes.
 */
@FunctionalInterface
public interface FlightPath {
    /** Half the interval over which {@link #acceleration} is averaged, s. */
    double HALF_INTERVAL = 0.25;

    /**
     * The drone's state at a time.
     *
     * @param time seconds since the start of the run, 0 or more
     */
    FlightState at(double time);

    /**
     * The drone's position at a time, m: bit for bit that of {@link #at}, but cheaper where the attitude takes long to
     * compute.
     *
     * @param time seconds since the start of the run, 0 or more
     */
    default Position position(double time) {
        return at(time).position();
    }

    /** A speed that the drone never exceeds on this path, m/s; empty if none is known. */
    default OptionalDouble topSpeed() {
        return OptionalDouble.empty();
    }

    /**
     * The drone's acceleration, which determines its tilt. By default, it is the mean over the half second around the
     * time t, computed from the velocities at the ends of that interval: {@code (v(t + h) - v(t - h)) / 2h}, h being a
     * quarter of a second; in the first quarter of a second, the interval begins at the start of the run. The value
     * does not depend on when it is queried. A jump in the velocity of a path gives a brief but finite acceleration. On
     * a circle flown at the speed v and the angular velocity omega, the mean points to the centre of the circle, and
     * its magnitude is {@code v omega} times {@code sin(omega h) / (omega h)}. A path whose future is not known yet
     * must override this method.
     *
     * @param time seconds since the start of the run, 0 or more
     * @return m/s2
     */
    default Position acceleration(double time) {
        double from = Math.max(0.0, time - HALF_INTERVAL);
        double to = time + HALF_INTERVAL;
        return at(to).velocity().minus(at(from).velocity()).times(1.0 / (to - from));
    }
}
