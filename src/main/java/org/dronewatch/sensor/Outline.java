package org.dronewatch.sensor;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;

/**
 * The geometry of a sensor's field of view, within its limits of range; it does not take into account occlusion, or how
 * far away the sensor detects a drone.
 */
public sealed interface Outline {
    /**
     * Tolerance, rad: rounding must not cut off what lies on an edge, least of all directly behind a radar that scans a
     * full circle.
     */
    double ROUNDING = 1e-9;

    /**
     * Whether a point is within the field of view.
     *
     * @param vector vector from the sensor, m
     */
    boolean contains(Position vector);

    /**
     * Whether some part of a sphere may be within a frustum: false only if no part is. For other shapes, whether the
     * centre of the sphere is within the field of view.
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
     * @param middleRight distance of the field's centre to the right of the axis at 1 m along it, m; 0 unless the lens
     *     is shifted
     * @param middleUp distance of the field's centre above the axis at 1 m along it, m
     * @param near distance along the axis at which the field begins, m
     * @param far distance along the axis at which the field ends, m; infinity if it has no end
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
        /** The vector to the centre of the field 1 m along the axis, m. */
        public Position middle() {
            return forward.plus(right.times(middleRight)).plus(up.times(middleUp));
        }

        /**
         * The corners of the field in the world frame, m, at a distance along its axis, clockwise from the top left.
         *
         * @param sensor position of the sensor, m
         * @param distance the distance, m
         */
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
     * @param minRange minimum distance, m
     * @param maxRange maximum distance, m
     */
    record Sector(
            double azimuth,
            double elevation,
            double azimuthWidth,
            double elevationWidth,
            double minRange,
            double maxRange)
            implements Outline {
        /** Whether the distance of a point is within the range limits. */
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
     * @param radius its radius, m
     */
    record Ball(double radius) implements Outline {
        @Override
        public boolean contains(Position vector) {
            return vector.length() <= radius;
        }
    }
}
