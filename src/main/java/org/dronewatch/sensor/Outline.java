package org.dronewatch.sensor;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;

/** The geometry of a sensor's field of view, for drawing: it takes no account of occlusion or of detection range. */
public sealed interface Outline {
    /**
     * Tolerance, rad: rounding must not cut off what lies on an edge, least of all directly behind a radar that scans a
     * full circle.
     */
    double ROUNDING = 1e-9;

    /**
     * Whether a point is within it.
     *
     * @param vector vector from the sensor, m
     */
    boolean contains(Position vector);

    /**
     * Whether some part of a sphere may be within it: false only if none is. For shapes other than a frustum, whether
     * the centre of the sphere is.
     *
     * @param vector vector from the sensor to the centre, m
     * @param radius radius of the sphere, m
     */
    default boolean mayShow(Position vector, double radius) {
        return contains(vector);
    }

    /**
     * The field of view of a camera's image: a frustum.
     *
     * @param forward unit vector of its axis
     * @param right unit vector to the right of the image
     * @param up unit vector to the top of the image
     * @param halfWidth half the width of the field at 1 m along the axis, m
     * @param halfHeight half the height of the field at 1 m along the axis, m
     * @param middleRight how far the middle of the field is to the right of the axis there, m; 0 unless the lens is
     *     shifted
     * @param middleUp how far it is above the axis there, m
     * @param near where it begins, as a distance along the axis, m
     * @param far where it ends, as a distance along the axis, m; infinity if it does not end
     */
    record Frustum(
            Position forward,
            Position right,
            Position up,
            double halfWidth,
            double halfHeight,
            double middleRight,
            double middleUp,
            double near,
            double far)
            implements Outline {
        /** The vector to the middle of the field 1 m along the axis, m. */
        public Position middle() {
            return forward.plus(right.times(middleRight)).plus(up.times(middleUp));
        }

        /** The corners of the field at a distance along its axis, in order, m. */
        public List<Position> corners(Position sensor, double distance) {
            List<Position> corners = new ArrayList<>();
            for (int i = 0; i < 4; i++) {
                double aside = i == 0 || i == 3 ? -halfWidth : halfWidth;
                double above = i < 2 ? halfHeight : -halfHeight;
                corners.add(sensor.plus(
                        middle().plus(right.times(aside)).plus(up.times(above)).times(distance)));
            }
            return corners;
        }

        @Override
        public boolean contains(Position vector) {
            double ahead = vector.dot(forward);
            return ahead >= near && ahead <= far && spans(vector);
        }

        /** {@inheritDoc} Compares the radius of the sphere with the distance of its centre from each of the planes. */
        @Override
        public boolean mayShow(Position vector, double radius) {
            double ahead = vector.dot(forward);
            double aside = Math.abs(vector.dot(right) - middleRight * ahead) - halfWidth * ahead;
            double above = Math.abs(vector.dot(up) - middleUp * ahead) - halfHeight * ahead;
            return ahead >= near - radius
                    && ahead <= far + radius
                    && aside <= radius * Math.hypot(1.0, halfWidth + Math.abs(middleRight))
                    && above <= radius * Math.hypot(1.0, halfHeight + Math.abs(middleUp));
        }

        /** Whether the direction of a vector is within the field, at any distance. */
        public boolean spans(Position vector) {
            double ahead = vector.dot(forward);
            return ahead > 0.0
                    && Math.abs(vector.dot(right) - middleRight * ahead) <= halfWidth * ahead
                    && Math.abs(vector.dot(up) - middleUp * ahead) <= halfHeight * ahead;
        }
    }

    /**
     * A field of view within given angles of a direction and between two distances.
     *
     * @param azimuth azimuth of its centre, clockwise from north, rad
     * @param elevation elevation of its centre, above the horizon, rad
     * @param azimuthWidth its width, rad; 2 pi for a full circle
     * @param elevationWidth its height, rad
     * @param minRange where it begins, m
     * @param maxRange where it ends, m
     */
    record Sector(
            double azimuth,
            double elevation,
            double azimuthWidth,
            double elevationWidth,
            double minRange,
            double maxRange)
            implements Outline {
        /** Whether a point is between the two distances. */
        public boolean reaches(Position vector) {
            double range = vector.length();
            return range >= minRange && range <= maxRange;
        }

        /** The explanation for a target outside the range limits: the limit that it violates. */
        public Explanation beyond(Position vector) {
            return Explanation.beyond(Cause.OUT_OF_RANGE, vector.length() < minRange ? minRange : maxRange);
        }

        @Override
        public boolean contains(Position vector) {
            double aside = Math.IEEEremainder(Math.atan2(vector.x(), vector.y()) - azimuth, 2.0 * Math.PI);
            double above = Math.atan2(vector.z(), Math.hypot(vector.x(), vector.y())) - elevation;
            return reaches(vector)
                    && Math.abs(aside) <= 0.5 * azimuthWidth + ROUNDING
                    && Math.abs(above) <= 0.5 * elevationWidth + ROUNDING;
        }
    }

    /**
     * A sphere around the sensor.
     *
     * @param radius m
     */
    record Ball(double radius) implements Outline {
        @Override
        public boolean contains(Position vector) {
            return vector.length() <= radius;
        }
    }
}
