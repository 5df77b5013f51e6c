package org.dronewatch.examples;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.World;

/**
 * A guard who looks around without binoculars, and notices a drone within line of sight once it appears large enough.
 *
 * @param position the guard's eyes, m
 * @param rate how often the guard looks around, Hz
 * @param acuity the smallest angular size at which the guard notices something in the sky, rad
 */
public record GuardSettings(
        Position position,
        @In(value = Quantity.FREQUENCY, above = 0.0, to = 10.0) double rate,
        @In(value = Quantity.ANGLE, from = 0.0003, to = 0.1) double acuity)
        implements SensorSettings<Sensor> {

    /** Checks the limits above. */
    public GuardSettings {
        Limits.check(GuardSettings.class, position, rate, acuity);
    }

    /** Looks around every two seconds, and notices what appears larger than four minutes of arc. */
    @Defaults("position")
    public static GuardSettings at(Position position) {
        return new GuardSettings(position, 0.5, 0.0012);
    }

    @Override
    public String kind() {
        return "guard";
    }

    @Override
    public GuardSettings withPosition(Position other) {
        return new GuardSettings(other, rate, acuity);
    }

    @Override
    public SensorDescription description() {
        return SensorDescription.measuring("apparent size");
    }

    @Override
    public Sensor create() {
        return this::look;
    }

    private List<Observation> look(World world, List<Drone> drones, Look look) {
        return drones.stream().map(drone -> look(world, drone, look)).toList();
    }

    private Observation look(World world, Drone drone, Look look) {
        double distance = drone.distance(position);
        boolean visible = !world.isOccluded(position.toPoint3d(), drone.position());
        double size = visible ? 2.0 * Math.atan(drone.radius() / distance) : 0.0;
        return new Observation(look.id(kind()), drone.id(), distance, new Reading(size, acuity, "rad"));
    }
}
