package org.dronewatch.sensor;

import java.util.List;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.world.World;

/** A sensor that can draw more of a drone than one value a look. */
public interface CurveSensor extends Sensor {
    /** What the random numbers of curves are drawn for: {@link Sample#random}. */
    String CURVES = "curves";

    /**
     * What there is to draw; often nothing.
     *
     * @param world the site
     * @param drone the drone as it is now
     * @param random random numbers for the purpose
     */
    List<Curve> curves(World world, Drone drone, RandomGenerator random);
}
