package org.dronewatch.viewer.tape;

import org.dronewatch.geometry.Position;

/**
 * The viewer's measuring tape: a straight line between two points of the site.
 *
 * @param from beginning of the line
 * @param to end of the line
 */
public record Tape(End from, End to) {
    private static final double WHOLE_TURN = 360.0;

    /**
     * An end of a tape.
     *
     * @param name name of the sensor or drone there; for another point, {@link #POINT}
     * @param place point from which distances are measured, m
     * @param eye point from which the line of sight is traced, m; slightly in front of the surface if {@code place}
     *     lies on one
     */
    public record End(String name, Position place, Position eye) {
        /** The name of an end that is neither a sensor nor a drone. */
        public static final String POINT = "a point";

        /** How far the eye of a point on a surface is in front of it, m: negligible when measuring. */
        private static final double IN_FRONT = 0.01;

        /**
         * As {@link #IN_FRONT}, but as a fraction of the distance from which the point was seen: depths are
         * single-precision.
         */
        private static final double ROUNDED = 1e-6;

        /** A sensor or drone, whose name is put between quotation marks. */
        public static End of(String id, Position place) {
            return new End("'" + id + "'", place, place);
        }

        /**
         * A point on a surface.
         *
         * @param place point on the surface, m
         * @param viewpoint point from which the surface is seen, m; the eye is on this side of the surface
         */
        public static End onSurface(Position place, Position viewpoint) {
            Position back = viewpoint.minus(place);
            double along = Math.min(1.0, IN_FRONT / back.length() + ROUNDED);
            return new End(POINT, place, place.plus(back.times(along)));
        }
    }

    private Position along() {
        return to.place().minus(from.place());
    }

    /** Length of the line, m. */
    public double distance() {
        return along().length();
    }

    /** Length of the line in plan view, m. */
    public double horizontal() {
        return Math.hypot(along().x(), along().y());
    }

    /** The height of the end above the beginning, m. */
    public double height() {
        return along().z();
    }

    /** Bearing of the end from the beginning, clockwise from north, degrees from 0 to 360; NaN for a vertical line. */
    public double bearingDeg() {
        if (horizontal() == 0.0) {
            return Double.NaN;
        }
        double bearing = Math.toDegrees(StrictMath.atan2(along().x(), along().y()));
        return bearing < 0.0 ? bearing + WHOLE_TURN : bearing;
    }

    /** Elevation of the end above the horizontal, seen from the beginning, degrees from -90 to 90. */
    public double elevationDeg() {
        return Math.toDegrees(StrictMath.atan2(height(), horizontal()));
    }
}
