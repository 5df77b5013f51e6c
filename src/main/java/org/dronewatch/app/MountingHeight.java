package org.dronewatch.app;

import java.util.Locale;
import java.util.Optional;
import org.dronewatch.analysis.survey.LineOfSight;
import org.dronewatch.geometry.Position;
import org.dronewatch.mesh.io.ModelRole;
import org.dronewatch.report.html.BlockerWords;
import org.dronewatch.run.Stage;
import org.dronewatch.setting.In;

/**
 * How high a sensor is above the first surface below it, which is not the one that was meant if coordinates are
 * mistyped.
 *
 * @param metres its height, m
 * @param surface the name of the surface
 */
record MountingHeight(double metres, String surface) {
    /** Sensors may stand exactly on a surface; their line of sight begins this much above it, m. */
    private static final double CLEAR = 1e-3;

    /** The mounting height at a position; empty if there is no surface below. */
    static Optional<MountingHeight> at(Position position, Stage stage) {
        Position from = new Position(position.x(), position.y(), position.z() + CLEAR);
        Position to = new Position(position.x(), position.y(), -2.0 * In.FARTHEST);
        return new LineOfSight(stage)
                .between(from, to)
                .map(below -> new MountingHeight(
                        Math.max(0.0, position.z() - below.at().z()),
                        below.blocker().obstacle().model().role() == ModelRole.TERRAIN
                                ? "the ground"
                                : BlockerWords.name(below.blocker())));
    }

    /** In words: {@code 3.0 m above the ground}. */
    String inWords() {
        return String.format(Locale.ROOT, "%.1f m above %s", metres, surface);
    }
}
