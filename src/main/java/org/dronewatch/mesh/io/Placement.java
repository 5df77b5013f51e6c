package org.dronewatch.mesh.io;

import org.dronewatch.geometry.Floats;
import org.dronewatch.geometry.Position;

/** Transforms coordinates of a model file into the world frame, one vertex at a time. */
final class Placement {
    private final boolean yUp;
    private final double scale;
    private final double cos;
    private final double sin;
    private final FilePoint origin;
    private final Position position;

    Placement(ModelSettings settings) {
        this.yUp = settings.upAxis() == UpAxis.Y;
        this.scale = settings.scale();
        // Compass bearings turn clockwise, mathematical angles counter-clockwise.
        this.cos = Math.cos(-settings.heading());
        this.sin = Math.sin(-settings.heading());
        this.origin = settings.origin();
        this.position = settings.position();
    }

    /** Appends the placed vertex. */
    void place(double fileX, double fileY, double fileZ, Floats target) {
        double modelX = fileX - origin.x();
        double modelY = fileY - origin.y();
        double modelZ = fileZ - origin.z();
        double x = scale * modelX;
        double y = scale * (yUp ? -modelZ : modelY);
        double z = scale * (yUp ? modelY : modelZ);
        target.add((float) (cos * x - sin * y + position.x()));
        target.add((float) (sin * x + cos * y + position.y()));
        target.add((float) (z + position.z()));
    }
}
