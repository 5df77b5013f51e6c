package org.dronewatch.run;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The line of sight between sensors and positions: whether a position is in a sensor's field of view, and whether
 * something hides it.
 */
public final class Sightline {
    private final Visibility visibility;

    /** Lines of sight in a world, for use by one thread. */
    public Sightline(World world) {
        this.visibility = new Visibility(world);
    }

    /** Whether a sensor has a field of view at all; microphones have none. */
    public static boolean hasFieldOfView(SensorSettings<?> sensor) {
        return Outlined.fieldOfView(sensor, Optional.empty()).isPresent();
    }

    /**
     * Whether a position is in a sensor's field of view and range now; always true for a sensor without a field of
     * view.
     */
    public static boolean isInField(SensorSettings<?> sensor, Optional<Pointing> pointing, Position position) {
        return Outlined.fieldOfView(sensor, pointing)
                .map(shape -> shape.contains(position.minus(sensor.position())))
                .orElse(true);
    }

    /**
     * Whether a sensor could see a position once its positioner has turned there: the position is in its field of view
     * and range, and nothing hides it.
     */
    public boolean isPossible(SensorSettings<?> sensor, Position position) {
        return isInField(sensor, Mounted.turnedTo(sensor, position), position)
                && visibility.isFree(sensor.position(), position);
    }

    /** The world. */
    public World world() {
        return visibility.world();
    }
}
