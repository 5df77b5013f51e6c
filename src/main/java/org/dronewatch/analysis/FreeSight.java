package org.dronewatch.analysis;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.flight.FlightState;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.World;
import org.dronewatch.world.WorldSettings;

/**
 * A drone in front of a sensor with nothing else around: the air, background noise, rain and light of a scene without
 * its models and noise sources. The sensor's axis is level, at the azimuth at which it is aimed (north for a sensor
 * without one); the drone is on that axis, at the sensor's height, and flies towards the sensor at its cruise speed. A
 * positioner has turned to the drone, as in {@link Coverage}.
 *
 * @param world conditions without models
 * @param drone the drone that is put in front of the sensor
 * @param sensor name of the sensor
 * @param seed of the run, for sensors that trace random rays
 */
record FreeSight(World world, Drone drone, String sensor, long seed) {

    /** The conditions of a scene's world, without its models and noise sources. */
    static FreeSight in(WorldSettings site, Drone drone, String sensor, long seed) {
        TriangleMesh nothing = new TriangleMesh(new float[0], new int[0], new int[0], new int[0], List.of());
        World free = new World(KDTree.of(nothing), site.noise(), site.surfaces(), site.atmosphere())
                .withRain(site.rain())
                .withLight(site.light());
        return new FreeSight(free, drone, sensor, seed);
    }

    /** A sensor that looks at the drone from any distance, m, and returns the probability that the look detects it. */
    Probability of(SensorSettings<?> settings) {
        Position axis = axis(settings);
        SensorSettings<?> level = settings.as(Aimed.class)
                .<SensorSettings<?>>map(aimed -> aimed.withAim(new Aim.Direction(Math.atan2(axis.x(), axis.y()), 0.0)))
                .orElse(settings);
        Assessor assessor = new Assessor(sensor, level, world);
        return range -> {
            Drone there = comingFrom(settings.position(), axis, range);
            Look look = Look.of(seed, sensor, 0, 0.0).withPointing(Mounted.turnedTo(level, there.origin()));
            return assessor.probability(there, look.pointing(), look.random(drone.id(), RaySensor.RAYS));
        };
    }

    private Drone comingFrom(Position sensor, Position axis, double range) {
        Position velocity = axis.times(-drone.settings().speed());
        double heading = Math.atan2(-axis.x(), -axis.y());
        return drone.at(new FlightState(sensor.plus(axis.times(range)), velocity, heading));
    }

    /** The level unit vector of a sensor's azimuth. */
    private static Position axis(SensorSettings<?> settings) {
        Position aim = settings.as(Aimed.class)
                .map(aimed -> aimed.aim().from(settings.position()))
                .orElse(new Position(0, 1, 0));
        double length = Math.hypot(aim.x(), aim.y());
        return length > 0.0 ? new Position(aim.x() / length, aim.y() / length, 0) : new Position(0, 1, 0);
    }

    /** How likely a look is to detect the drone at a range. */
    @FunctionalInterface
    interface Probability {
        /** The probability at a range in m, 0 to 1. */
        double at(double range);
    }
}
