package org.dronewatch.viewer;

import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.world.SurfaceColumn;
import org.dronewatch.world.World;

/** Finds what a sensor stands on: the ground, a floor or a roof below it. */
record Foothold(World world) {
    /**
     * A surface that is higher than a point by no more than this still counts as below it, m: depths of pixels are
     * rounded.
     */
    private static final double ROUNDED = 0.05;

    /** The surface below a position, m; empty where there is none. */
    OptionalDouble below(Position at) {
        return below(at.x(), at.y(), at.z());
    }

    /** The surface at a point of the site, m, or below it, as at the foot of a wall. */
    OptionalDouble below(double x, double y, double z) {
        return height(SurfaceColumn.at(world, x, y).standing(z + ROUNDED));
    }

    /**
     * The surface on which something stands once it has been moved to another place, m: the highest one there if it
     * stands on the highest one where it is now, otherwise the highest one below it.
     *
     * @param from where it is now
     */
    OptionalDouble after(Position from, double x, double y) {
        SurfaceColumn here = SurfaceColumn.at(world, from.x(), from.y());
        double top = here.standing(Double.POSITIVE_INFINITY)
                .map(SurfaceColumn.Surface::z)
                .orElse(Double.NEGATIVE_INFINITY);
        double limit = from.z() + ROUNDED >= top ? Double.POSITIVE_INFINITY : from.z() + ROUNDED;
        return height(SurfaceColumn.at(world, x, y).standing(limit));
    }

    private static OptionalDouble height(Optional<SurfaceColumn.Surface> surface) {
        return surface.map(found -> OptionalDouble.of(found.z())).orElse(OptionalDouble.empty());
    }

    /** Whether a position is inside something solid, or below the ground. */
    boolean isInside(Position at) {
        return SurfaceColumn.at(world, at.x(), at.y()).isInside(at.z());
    }
}
