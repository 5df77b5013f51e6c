package org.dronewatch.examples;

import java.util.Map;
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
 * A lookout who looks around, and notices a drone within line of sight by chance: the nearer it is, the more likely.
 *
 * @param position the lookout's eyes, m
 * @param rate how often the lookout looks around, Hz
 */
public record LookoutSettings(Position position, @In(value = Quantity.FREQUENCY, above = 0.0, to = 10.0) double rate)
        implements SensorSettings<Sensor> {

    /** Checks the limits above. */
    public LookoutSettings {
        Limits.check(LookoutSettings.class, position, rate);
    }

    /** Looks around every two seconds. */
    @Defaults("position")
    public static LookoutSettings at(Position position) {
        return new LookoutSettings(position, 0.5);
    }

    @Override
    public String kind() {
        return "lookout";
    }

    @Override
    public LookoutSettings withPosition(Position other) {
        return new LookoutSettings(other, rate);
    }

    @Override
    public SensorDescription description() {
        return SensorDescription.measuring("probability of detection");
    }

    @Override
    public Sensor create() {
        return (world, drones, look) ->
                drones.stream().map(drone -> look(world, drone, look)).toList();
    }

    private Observation look(World world, Drone drone, Look look) {
        double distance = drone.distance(position);
        boolean visible = !world.isOccluded(position.toPoint3d(), drone.position());
        double probability = visible ? Math.exp(-distance / 300.0) : 0.0;
        // Above 0, so that what has a probability of 0 is never detected.
        double drawn = 1.0 - look.random(drone.id(), Look.DETECTION).nextDouble();
        return new Observation(look.id(kind()), drone.id(), distance, new Reading(probability, drawn, ""))
                .withFigures(Map.of(Observation.PROBABILITY, probability));
    }
}
