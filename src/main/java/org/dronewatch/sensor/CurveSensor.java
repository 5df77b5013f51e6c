package org.dronewatch.sensor;

import java.util.List;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.world.World;

/** A sensor that can draw more about a drone than one value per look. */
public interface CurveSensor extends Sensor {
    /** The purpose of the random numbers of curves: {@link Look#random}. */
    String CURVES = "curves";

    /**
     * The curves to draw; often none.
     *
     * @param world the site
     * @param drone the drone as it is now
     * @param random random numbers for the purpose
     */
    List<Curve> curves(World world, Drone drone, RandomGenerator random);
}
