package org.dronewatch.run.advice;

import java.util.Locale;
import java.util.Map;
import java.util.function.Consumer;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.SteeredFlight;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.radio.GroundReflecting;
import org.dronewatch.sensor.radio.ReflectingGround;
import org.dronewatch.world.Ground;

/**
 * Warns of sensors and flights where a terrain has no ground: beyond its rim or over a hole, nothing hides a drone,
 * because nothing is known there. Also warns if the earth's curvature is applied to ground that is already curved.
 *
 * @param ground the highest surfaces of the world
 */
public record TerrainAdvice(SceneSettings settings, Ground ground) {
    /** The number of positions along a flight that are examined. */
    private static final int PLACES = 200;

    /**
     * Gives one line for each sensor and each flight that is somewhere beyond the known ground, and for each sensor
     * that applies the earth's curvature to curved ground.
     */
    public void giveTo(Map<String, FlightPath> flights, Consumer<String> target) {
        settings.enabledSensors().forEach((id, sensor) -> {
            Position at = sensor.position();
            if (isBeyond(at)) {
                target.accept(String.format(
                        Locale.ROOT,
                        "sensor '%s' at (%.1f, %.1f) m has no terrain below it: it is unknown whether anything hides drones there",
                        id,
                        at.x(),
                        at.y()));
            }
            if (reflectsFromRoundEarth(sensor)) {
                target.accept("sensor '" + id + "' has groundReflection.roundEarth, but the ground from files already"
                        + " follows the earth's curvature, which is thus applied twice: set roundEarth to false");
            }
        });
        flights.forEach((id, path) -> {
            if (SteeredFlight.in(path).isEmpty()) {
                onFlight(id, path, target);
            }
        });
    }

    private static boolean reflectsFromRoundEarth(SensorSettings<?> sensor) {
        return sensor.as(GroundReflecting.class)
                .flatMap(GroundReflecting::groundReflection)
                .filter(ReflectingGround::roundEarth)
                .isPresent();
    }

    private void onFlight(String id, FlightPath path, Consumer<String> target) {
        for (int i = 0; i <= PLACES; i++) {
            double time = settings.run().duration() * i / PLACES;
            Position at = path.at(time).position();
            if (isBeyond(at)) {
                target.accept(String.format(
                        Locale.ROOT,
                        "drone '%s' has no terrain below it at %.1f s, at (%.1f, %.1f) m: it is unknown whether anything hides it there",
                        id,
                        time,
                        at.x(),
                        at.y()));
                return;
            }
        }
    }

    private boolean isBeyond(Position at) {
        return ground.height(at.x(), at.y()).isEmpty();
    }
}
