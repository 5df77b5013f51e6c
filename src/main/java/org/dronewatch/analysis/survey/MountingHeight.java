package org.dronewatch.analysis.survey;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.dronewatch.run.Stage;
import org.dronewatch.setting.In;

/**
 * How high a sensor is above the first surface below it.
 *
 * @param metres height of the sensor above the surface, 0 or more, m
 * @param surface what the surface belongs to
 */
public record MountingHeight(double metres, Blocker surface) {
    /** Sensors may stand exactly on a surface; the search begins this much above them, m. */
    private static final double CLEAR = 1e-3;

    /** The mounting height of a position; empty if there is no surface below it. */
    public static Optional<MountingHeight> at(Position position, Stage stage) {
        Position from = new Position(position.x(), position.y(), position.z() + CLEAR);
        Position to = new Position(position.x(), position.y(), -2.0 * In.FARTHEST);
        return new LineOfSight(stage)
                .between(from, to)
                .map(below -> new MountingHeight(
                        Math.max(0.0, position.z() - below.at().z()), below.blocker()));
    }
}
