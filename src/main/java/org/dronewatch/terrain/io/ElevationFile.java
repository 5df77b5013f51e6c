package org.dronewatch.terrain.io;

import java.io.IOException;
import java.util.Optional;
import org.dronewatch.geo.CoordinateReferenceSystem;

/**
 * A file of elevation posts, whose positions are known and whose heights are read when they are needed. One thread at a
 * time.
 */
public interface ElevationFile {
    /** Its name in messages. */
    String name();

    /** The number of its columns of posts, 2 or more. */
    int columns();

    /** The number of its rows of posts, 2 or more. */
    int rows();

    /** The positions of its posts. */
    Lattice lattice();

    /** The coordinate reference system that the file states, if it does. */
    Optional<CoordinateReferenceSystem> crs();

    /**
     * The heights of some posts, row by row, m; NaN for those without one.
     *
     * @param window within the file
     * @throws IOException when the file ends early, or cannot be read
     * @throws org.dronewatch.setting.InputException when it is damaged
     */
    float[] heights(Window window) throws IOException;

    /** Whether its heights are known to include roofs and treetops. */
    boolean isSurfaceModel();

    /** Whether the file states a height that means "no data". */
    boolean statesNodata();
}
