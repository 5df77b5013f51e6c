package org.dronewatch.analysis.field;

import java.util.List;
import java.util.Optional;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Draws;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.World;

/**
 * One sensor and a drone that is put anywhere on any course.
 *
 * @param world the site
 * @param drone the drone, anywhere
 * @param sensor name of the sensor
 * @param settings of the sensor
 * @param seed of the run, for sensors that trace random rays
 * @param courses of the drone
 * @param terms on which it counts as detected
 */
record FieldProbe(
        World world,
        Drone drone,
        String sensor,
        SensorSettings<?> settings,
        long seed,
        List<Course> courses,
        FieldTerms terms) {

    /** An assessor for one thread. */
    Assessor newAssessor() {
        return new Assessor(sensor, settings, world);
    }

    /** The drone at a place, m, on a course given by its number. */
    Drone drone(Position at, int course) {
        return drone.at(state(at, course));
    }

    /** The state of the drone at a place, m, on a course given by its number. */
    FlightState state(Position at, int course) {
        return courses.get(course).at(at, drone.settings().speed());
    }

    /** Where the sensor's positioner points once it has turned to a place, m; empty on a fixed mount. */
    Optional<Pointing> pointing(Position at) {
        return Mounted.turnedTo(settings, at);
    }

    /**
     * The same, except for what the steps of a {@link SensorLayer} do not tell apart, and faster.
     */
    Assessment assessInSteps(Assessor assessor, Drone there, Optional<Pointing> pointing) {
        return assessor.assessCoarsely(
                there, pointing, Draws.stream(seed, sensor, drone.id(), 0, RaySensor.RAYS), terms.high(settings));
    }

    /**
     * The probability that the sensor detects the drone on the terms of the field, in the steps of a
     * {@link SensorLayer}.
     *
     * @param ofALook the probability of a look, 0 to 1
     */
    int steps(double ofALook) {
        return SensorLayer.steps(terms.probability(ofALook, settings));
    }

    /**
     * The assessment of the drone with the random rays of the first look of a run: they are the same for all cells, so
     * that the field varies with the place alone.
     */
    Assessment assess(Assessor assessor, Drone there, Optional<Pointing> pointing) {
        return assessor.assess(there, pointing, Draws.stream(seed, sensor, drone.id(), 0, RaySensor.RAYS));
    }
}
