package org.dronewatch.sensor;

import java.util.Optional;
import java.util.function.DoubleToIntFunction;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.world.World;

/**
 * A sensor that can bound the assessment of a level drone at little cost, for fields of assessments at many positions.
 * Queries for the same position should follow one another.
 */
public interface BoundingSensor extends AssessableSensor {

    /**
     * An equivalent sensor for use by another thread; the two share what threads can share, such as the image of the
     * site.
     */
    BoundingSensor sibling();

    /**
     * Bounds that hold at every heading and speed of a level drone.
     *
     * @param world the site
     * @param drone the drone, at any position
     * @param at assumed position of its origin, m
     * @param pointing where a positioner points the sensor; empty for the aim in its settings
     * @return empty where the assessment depends on the heading, or no bounds are known
     */
    Optional<AssessmentBounds> boundAtAllHeadings(World world, Drone drone, Position at, Optional<Pointing> pointing);

    /**
     * Bounds for a state of a drone; other parameters as for {@link #boundAtAllHeadings}.
     *
     * @param state the assumed state of flight, which is level
     * @param steps maps a probability to a step, which never decreases as the probability increases; probabilities of
     *     the same step count as equal
     * @return empty where it is faster to assess the drone
     */
    Optional<AssessmentBounds> bound(
            World world, Drone drone, FlightState state, Optional<Pointing> pointing, DoubleToIntFunction steps);

    /**
     * An upper bound on the margin of a drone in a given state, dB; other parameters as for {@link #bound}. The bounds
     * that {@code bound} returns depend on what earlier queries have prepared; this upper bound does not depend on the
     * order of queries.
     */
    double greatestMarginDb(World world, Drone drone, FlightState state, Optional<Pointing> pointing);
}
