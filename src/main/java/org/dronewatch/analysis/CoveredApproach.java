package org.dronewatch.analysis;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.Visibility;
import org.dronewatch.world.World;

/**
 * The straight approach to the world's origin, low over the ground, on which a drone is hidden from a given point for
 * the greatest fraction of its flight.
 *
 * @param azimuth direction of the start from the origin, rad clockwise from north
 * @param start first point of the approach, at the height of the drone above the surface, m
 * @param hidden the fraction of the approach on which the drone is hidden, 0 to 1
 */
public record CoveredApproach(double azimuth, Position start, double hidden) {
    private static final int DIRECTIONS = 16;
    private static final int STEPS = 60;

    /**
     * Finds the approach by comparing sixteen directions.
     *
     * @param watcher the point from which the drone would be seen, m
     * @param length length of the approach, m
     * @param height height of the drone above the highest surface below it, m
     * @return empty if no direction has ground below the whole approach
     */
    public static Optional<CoveredApproach> to(World world, Position watcher, double length, double height) {
        Visibility visibility = new Visibility(world);
        Optional<CoveredApproach> best = Optional.empty();
        for (int i = 0; i < DIRECTIONS; i++) {
            double azimuth = 2.0 * Math.PI * i / DIRECTIONS;
            Optional<CoveredApproach> one = from(azimuth, world, visibility, watcher, length, height);
            if (one.isPresent() && (best.isEmpty() || one.get().hidden > best.get().hidden)) {
                best = one;
            }
        }
        return best;
    }

    private static Optional<CoveredApproach> from(
            double azimuth, World world, Visibility visibility, Position watcher, double length, double height) {
        int hidden = 0;
        Position start = watcher;
        for (int k = 1; k <= STEPS; k++) {
            double x = length * k / STEPS * Math.sin(azimuth);
            double y = length * k / STEPS * Math.cos(azimuth);
            OptionalDouble ground = world.surfaceHeight(x, y);
            if (ground.isEmpty()) {
                return Optional.empty();
            }
            start = new Position(x, y, ground.getAsDouble() + height);
            hidden += visibility.isFree(watcher, start) ? 0 : 1;
        }
        return Optional.of(new CoveredApproach(azimuth, start, (double) hidden / STEPS));
    }
}
