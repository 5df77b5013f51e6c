package org.example.watch;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.world.World;

/**
 * Someone with binoculars who sees whatever is near enough and not hidden.
 *
 * @param position of the eyes, m
 * @param rate how often they look, Hz
 * @param reach how far they see, m
 */
public record SpotterSettings(
        Position position,
        @In(value = Quantity.FREQUENCY, above = 0.0, to = 10.0) double rate,
        @In(value = Quantity.LENGTH, above = 0.0, to = 5000.0) double reach)
        implements SensorSettings<Sensor> {
    public SpotterSettings {
        Limits.check(SpotterSettings.class, position, rate, reach);
    }

    @Defaults("position")
    public static SpotterSettings at(Position position) {
        return new SpotterSettings(position, 2.0, 150.0);
    }

    @Override
    public String kind() {
        return "spotter";
    }

    @Override
    public SpotterSettings withPosition(Position other) {
        return new SpotterSettings(other, rate, reach);
    }

    @Override
    public SensorDescription description() {
        return SensorDescription.measuring("share of the reach");
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
        double value = visible ? reach / distance : 0.0;
        return new Observation(look.id(kind()), drone.id(), distance, new Reading(value, 1.0, ""));
    }
}
