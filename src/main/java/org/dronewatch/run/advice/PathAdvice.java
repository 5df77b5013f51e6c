package org.dronewatch.run.advice;

import java.util.Locale;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Ground;
import org.dronewatch.world.World;

/**
 * Warns of a flight that passes below the ground or through a solid building, which would hide the drone from every
 * sensor: one line for each drone.
 *
 * @param id name of the drone
 * @param world the world, with its ground and its buildings
 * @param ground the highest surfaces of the world
 * @param duration duration of the run, s
 */
public record PathAdvice(String id, World world, Ground ground, double duration) {
    /** The greatest interval between the times at which a flight is examined, s. */
    private static final double STEP = 0.2;

    /**
     * The greatest number of positions along a flight that are examined: with one ray each, or 26 more where something
     * is above it.
     */
    private static final int MOST_PLACES = 1000;

    /** The depth below the surface that a drone may have, m: one that stands on the ground touches it. */
    private static final double TOUCH = 0.1;

    /** Gives one line with the first point at which the drone is inside something solid, and the greatest depth. */
    public void giveTo(FlightPath path, Consumer<String> target) {
        int steps = (int) Math.min(MOST_PLACES, Math.max(1.0, Math.ceil(duration / STEP)));
        String first = null;
        double deepest = 0.0;
        for (int i = 0; i <= steps; i++) {
            double time = duration * i / steps;
            Position at = path.at(time).position();
            double depth = depth(at);
            if (depth > TOUCH && world.isInsideWall(at)) {
                first = first == null ? inWords(time, at) : first;
                deepest = Math.max(deepest, depth);
            }
        }
        if (first != null) {
            target.accept(String.format(
                    Locale.ROOT,
                    "drone '%s' flies below the ground or through a solid building: first at %s, and up to %.1f m below"
                            + " the surface above it",
                    id,
                    first,
                    deepest));
        }
    }

    /** How far the highest surface is above a place, m; 0 or less where there is none above it. */
    private double depth(Position at) {
        OptionalDouble surface = ground.height(at.x(), at.y());
        return surface.isPresent() ? surface.getAsDouble() - at.z() : 0.0;
    }

    private static String inWords(double time, Position at) {
        return String.format(Locale.ROOT, "%.1f s, at (%.1f, %.1f, %.1f) m", time, at.x(), at.y(), at.z());
    }
}
