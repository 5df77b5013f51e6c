package org.dronewatch.mesh.io;

import org.dronewatch.setting.In;
import org.dronewatch.setting.InOrder;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;

/**
 * A point in the coordinates of a model file, in the file's unit and along its axes. Unlike the coordinates of a
 * position, those of a file point may be as large as the coordinates of a national grid, even in millimetres.
 *
 * @param x first coordinate in the file, -1e10 to 1e10 of the file's units
 * @param y second coordinate in the file, -1e10 to 1e10 of the file's units
 * @param z third coordinate in the file, -1e10 to 1e10 of the file's units
 */
@InOrder
public record FilePoint(
        @In(value = Quantity.NUMBER, from = -1e10, to = 1e10) double x,
        @In(value = Quantity.NUMBER, from = -1e10, to = 1e10) double y,
        @In(value = Quantity.NUMBER, from = -1e10, to = 1e10) double z) {
    /** The file's own origin. */
    static final FilePoint ZERO = new FilePoint(0, 0, 0);

    /**
     * Checks the limits.
     *
     * @throws IllegalArgumentException if a value is out of range
     */
    public FilePoint {
        Limits.check(FilePoint.class, x, y, z);
    }
}
