package org.dronewatch.scene;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.World;

/**
 * A sensor of pure chance, written as a user would write one of an own kind: it shows which random numbers are drawn.
 */
public record DiceSettings(Position position, @In(Quantity.FREQUENCY) double rate, @In(Quantity.NUMBER) double luck)
        implements SensorSettings<Sensor> {

    @Override
    public DiceSettings withPosition(Position other) {
        return new DiceSettings(other, rate, luck);
    }

    @Override
    public String kind() {
        return "dice";
    }

    @Override
    public Sensor create() {
        return this::observe;
    }

    private List<Observation> observe(World world, List<Drone> drones, Look look) {
        return drones.stream()
                .map(drone -> new Observation(
                        look.id(kind()),
                        drone.id(),
                        drone.distance(position),
                        new Reading(look.random(drone.id(), Look.DETECTION).nextDouble(), luck, "")))
                .toList();
    }
}
