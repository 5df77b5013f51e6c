package org.dronewatch.terrain.io;

import java.io.IOException;
import java.util.Optional;
import org.dronewatch.geo.CoordinateReferenceSystem;
import org.dronewatch.setting.InputException;

/**
 * A file of elevation posts, whose positions are known and whose heights are read when they are needed. For use by one
 * thread at a time.
 */
public interface ElevationFile {
    /** The name of the file in messages. */
    String name();

    /** The number of columns of posts, 2 or more. */
    int columns();

    /** The number of rows of posts, 2 or more. */
    int rows();

    /** The positions of the posts. */
    Lattice lattice();

    /**
     * The coordinate reference system that the file states; empty if it states none.
     *
     * @throws InputException when it states a code that is not known
     */
    Optional<CoordinateReferenceSystem> crs();

    /**
     * The code of the system that the file states, known or not, such as {@code EPSG:25832}; empty if it states none.
     */
    default Optional<String> statedCrs() {
        return crs().map(CoordinateReferenceSystem::name);
    }

    /** Whether the scene has to state the system of the posts: the file states none, or one that is not known. */
    default boolean needsCrs() {
        try {
            return crs().isEmpty();
        } catch (InputException e) {
            return true;
        }
    }

    /** Whether the unit of the heights is known: the file states it, or its format prescribes it. */
    boolean statesUnit();

    /**
     * The heights of some posts, row by row, m; NaN for those without one.
     *
     * @param window the columns and rows of the posts, all within the file
     * @throws IOException when the file ends early, or cannot be read
     * @throws InputException when it is damaged
     */
    float[] heights(Window window) throws IOException;

    /** Whether the heights are known to include roofs and treetops. */
    boolean isSurfaceModel();

    /** Whether the file states a height that means "no data". */
    boolean statesNodata();
}
