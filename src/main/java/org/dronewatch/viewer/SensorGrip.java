package org.dronewatch.viewer;

import java.util.Optional;
import org.dronewatch.geometry.Position;
import org.jogamp.vecmath.Point2d;

/**
 * Drags the selected sensor through the site: the point on which it stands follows the pointer. For the event thread.
 */
final class SensorGrip implements WorldGrip {
    /** The place below a sensor counts as visible if what is drawn at its pixel is within this distance of it, m. */
    private static final double SAME = 2.0;

    private final WorldPanel world;
    private final SensorMover mover;

    /** The offset from the pointer to the place below the sensor, in pixels. */
    private double right;

    private double down;
    private double above;

    SensorGrip(WorldPanel world, SensorMover mover) {
        this.world = world;
        this.mover = mover;
    }

    @Override
    public boolean isAt(int x, int y) {
        return mover.movable()
                .filter(sensor -> world.isSymbolAt(sensor.position(), x, y))
                .isPresent();
    }

    @Override
    public void take(int x, int y) {
        above = mover.above();
        Optional<Point2d> foot = mover.foot().flatMap(this::visible);
        right = foot.map(at -> at.x - x).orElse(0.0);
        down = foot.map(at -> at.y - y).orElse(0.0);
        mover.begin();
    }

    /** The pixel of a place, unless something is in front of it. */
    private Optional<Point2d> visible(Position place) {
        return world.pixelOf(place).filter(at -> world.placeAt((int) at.x, (int) at.y)
                .filter(drawn -> drawn.minus(place).length() < SAME)
                .isPresent());
    }

    @Override
    public void drag(int x, int y) {
        mover.drag(world.placeAt((int) Math.round(x + right), (int) Math.round(y + down)), above);
    }
}
