package org.dronewatch.analysis.survey;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.Visibility;

/**
 * Lines of sight between points of a site, judged by the same {@link Visibility} as those of the sensors. Keeps scratch
 * memory: for use by one thread at a time.
 */
public final class LineOfSight {
    private final Visibility visibility;
    private final BlockerSearch search;

    /**
     * What blocks a line of sight.
     *
     * @param blocker the first surface on the line
     * @param at where the line meets that surface, m
     */
    public record Blocked(Blocker blocker, Position at) {}

    /** Lines of sight at the site of a stage; drones block none of them. */
    public LineOfSight(Stage stage) {
        this.visibility = new Visibility(stage.world());
        this.search = new BlockerSearch(stage);
    }

    /**
     * The first obstacle on the line from one point to another; empty if they are mutually visible.
     *
     * @param from where the line begins, m
     * @param to where the line ends, m
     */
    public Optional<Blocked> between(Position from, Position to) {
        if (visibility.obstacle(from, to).isEmpty()) {
            return Optional.empty();
        }
        Position at = from.plus(to.minus(from).times(visibility.distance()));
        Obstacle surface = visibility.world().obstacle(visibility.triangle());
        return Optional.of(new Blocked(search.between(from, to, surface), at));
    }
}
