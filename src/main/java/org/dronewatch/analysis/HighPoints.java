package org.dronewatch.analysis;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.world.World;

/** The highest points of a site's surface, ground or roofs, as sites for masts. */
public final class HighPoints {
    /** Points along half a side of the square in which they are searched for. */
    private static final int STEPS = 40;

    private HighPoints() {}

    /**
     * The highest points near the world's origin, the highest first.
     *
     * @param within maximum distance from the origin along each axis, m
     * @param count maximum number of points
     * @param apart minimum distance between them, m
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; its interrupt status is kept
     */
    public static List<Position> near(World world, double within, int count, double apart) {
        List<Position> candidates = new ArrayList<>();
        for (int i = -STEPS; i <= STEPS; i++) {
            Workers.checkInterrupted();
            for (int j = -STEPS; j <= STEPS; j++) {
                double x = within * i / STEPS;
                double y = within * j / STEPS;
                OptionalDouble height = world.surfaceHeight(x, y);
                height.ifPresent(z -> candidates.add(new Position(x, y, z)));
            }
        }
        // Of several equally high points, the one nearest to the middle comes first.
        candidates.sort(Comparator.comparingDouble((Position point) -> -point.z())
                .thenComparingDouble(point -> Math.hypot(point.x(), point.y())));
        List<Position> chosen = new ArrayList<>();
        for (Position point : candidates) {
            if (chosen.size() < count && chosen.stream().allMatch(other -> other.distance(point) >= apart)) {
                chosen.add(point);
            }
        }
        return chosen;
    }
}
