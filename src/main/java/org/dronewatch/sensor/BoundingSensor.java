package org.dronewatch.sensor;

import java.util.Optional;
import java.util.function.DoubleToIntFunction;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.world.World;

/**
 * A sensor that can bound the assessment of a level drone at little cost: for fields of assessments at many places.
 * Queries at one place should follow each other.
 */
public interface BoundingSensor extends AssessableSensor {

    /** The same sensor for another thread: it shares what all threads can use, such as the image of the site. */
    BoundingSensor sibling();

    /**
     * Bounds that hold at every heading and speed of a level drone.
     *
     * @param world the site
     * @param drone the drone, wherever it is
     * @param at where its origin is assumed to be, m
     * @param pointing where a positioner points the sensor; empty for its own aim
     * @return empty where headings differ, or no bounds are known
     */
    Optional<AssessmentBounds> boundAtAllHeadings(World world, Drone drone, Position at, Optional<Pointing> pointing);

    /**
     * Bounds for a state of a drone; other parameters as for {@link #boundAtAllHeadings}.
     *
     * @param state where and how it is assumed to fly: level
     * @param steps gives the step of a probability, which never falls as the probability grows; those of one step
     *     count as equal
     * @return empty where it is faster to assess the drone
     */
    Optional<AssessmentBounds> bound(
            World world, Drone drone, FlightState state, Optional<Pointing> pointing, DoubleToIntFunction steps);

    /**
     * An upper bound on the margin of a drone in a state, dB; other parameters as for {@link #bound}. The bounds given
     * there depend on what has been prepared for earlier queries; this one is the same in any order of queries.
     */
    double greatestMarginDb(World world, Drone drone, FlightState state, Optional<Pointing> pointing);
}
