package org.dronewatch.sensor;

import java.util.List;
import java.util.random.RandomGenerator;
import org.dronewatch.drone.Drone;
import org.dronewatch.world.World;

/** A sensor that can provide curves for a drone, such as a spectrum. */
public interface CurveSensor extends Sensor {
    /** The purpose of the random numbers that are drawn for curves; see {@link Look#random}. */
    String CURVES = "curves";

    /**
     * The curves for a drone; often none.
     *
     * @param world the site
     * @param drone the drone in its present state
     * @param random random numbers for the purpose {@link #CURVES}
     */
    List<Curve> curves(World world, Drone drone, RandomGenerator random);
}
