package org.dronewatch.sensor;

import java.util.List;
import java.util.function.Consumer;
import org.dronewatch.geometry.Position;

/** A sensor of a user that observes nothing and does something at each look, such as to fail or to wait. */
public record ActingSettings(Position position, double rate, Consumer<Look> action) implements SensorSettings<Sensor> {
    @Override
    public ActingSettings withPosition(Position other) {
        return new ActingSettings(other, rate, action);
    }

    @Override
    public String kind() {
        return "acting";
    }

    @Override
    public Sensor create() {
        return (world, drones, look) -> {
            action.accept(look);
            return List.of();
        };
    }
}
