package org.dronewatch.terrain.io;

import java.io.IOException;
import java.util.Optional;
import org.dronewatch.geo.CoordinateReferenceSystem;

/** A file of posts: where they are is known, their heights are read when they are needed. One thread at a time. */
public interface ElevationFile {
    /** Its name in messages. */
    String name();

    /** How many columns of posts it has, 2 or more. */
    int columns();

    /** How many rows of posts it has, 2 or more. */
    int rows();

    /** Where its posts are. */
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

    /** Whether heights are known to be those of roofs and treetops. */
    boolean isSurfaceModel();

    /** Whether the file says which height stands for none. */
    boolean statesNodata();
}
