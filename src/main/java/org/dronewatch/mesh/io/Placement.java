package org.dronewatch.mesh.io;

import java.util.Optional;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.geo.MapTransform;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Floats;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.InputException;

/**
 * Transforms coordinates of a model file into the world frame, one vertex at a time; only the result is rounded to
 * single precision. For use by one thread.
 */
final class Placement {
    private final boolean yUp;
    private final double scale;
    private final double cos;
    private final double sin;
    private final FilePoint origin;
    private final Position position;
    private final Optional<MapTransform> grid;
    /** Length of the grid's unit, m. */
    private final double gridUnit;

    /**
     * The placement of one model.
     *
     * @param settings of the model
     * @param sceneOrigin geographic position of the world's origin, if known
     * @throws InputException when the model is in a national grid, and the world's origin is not known
     */
    Placement(ModelSettings settings, Optional<Origin> sceneOrigin) {
        this.yUp = settings.upAxis() == UpAxis.Y;
        this.scale = settings.scale();
        // Compass bearings turn clockwise, mathematical angles counter-clockwise.
        this.cos = Math.cos(-settings.heading());
        this.sin = Math.sin(-settings.heading());
        this.origin = settings.origin();
        this.position = settings.position();
        Optional<CoordinateReferenceSystem> crs = settings.crs().map(CoordinateReferenceSystem::of);
        this.grid = crs.map(system -> new MapTransform(
                system,
                sceneOrigin.orElseThrow(() -> new InputException(settings.shownFile() + ": crs " + system
                        + " needs a world.origin, the latitude and longitude of x = y = 0"))));
        this.gridUnit = crs.map(CoordinateReferenceSystem::unitLength).orElse(1.0);
    }

    /**
     * Appends the placed vertex.
     *
     * @throws InputException whose message is part of a line, when it lies where the grid has no coordinates
     */
    void place(double fileX, double fileY, double fileZ, Floats target) {
        double modelX = fileX - origin.x();
        double modelY = fileY - origin.y();
        double modelZ = fileZ - origin.z();
        double x = scale * modelX;
        double y = scale * (yUp ? -modelZ : modelY);
        double z = scale * (yUp ? modelY : modelZ);
        if (grid.isPresent()) {
            Position there = grid.get().inWorld(x / gridUnit, y / gridUnit, z);
            target.add((float) (there.x() + position.x()));
            target.add((float) (there.y() + position.y()));
            target.add((float) (there.z() + position.z()));
            return;
        }
        target.add((float) (cos * x - sin * y + position.x()));
        target.add((float) (sin * x + cos * y + position.y()));
        target.add((float) (z + position.z()));
    }
}
