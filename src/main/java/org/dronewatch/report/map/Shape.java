package org.dronewatch.report.map;

import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geo.GeoPoint;

/** The geometry of a map feature. */
sealed interface Shape {

    /** A single position. */
    record Point(GeoPoint position) implements Shape {}

    /**
     * A path from position to position.
     *
     * @param positions two or more
     */
    record Line(List<GeoPoint> positions) implements Shape {
        /** Copies the list: later changes by the caller have no effect. */
        public Line {
            positions = List.copyOf(positions);
        }
    }

    /**
     * An area on the ground plan.
     *
     * @param rings its edge, counterclockwise, and then its holes, clockwise; each ends where it begins
     * @param top height above the ground of the top of whatever covers it, m; empty for a mark on the ground
     */
    record Area(List<List<GeoPoint>> rings, OptionalDouble top) implements Shape {
        /** Copies the lists: later changes by the caller have no effect. */
        public Area {
            rings = rings.stream().map(List::copyOf).toList();
        }
    }
}
