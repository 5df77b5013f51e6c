package org.dronewatch.buildings;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * A roof whose height at each point is that of the lowest of several planes there: gables, hips, pyramids, domes and
 * single slopes are of this kind. Heights are measured from the eaves.
 *
 * @param planes the planes, no two of which are the same
 */
record RoofPlanes(List<Slope> planes) {
    /** How many flat rings approximate the curve of a dome. */
    static final int RINGS_OF_A_DOME = 6;

    private static final double SAME = 1e-9;

    /**
     * A plane, of height {@code base + east x + north y}.
     *
     * @param base at the frame's origin, m
     * @param east how much it rises to the east
     * @param north how much it rises to the north
     */
    record Slope(double base, double east, double north) {
        /** One that has a height at a point and falls in a direction, a unit vector. */
        static Slope through(double x, double y, double height, double fallX, double fallY, double fall) {
            return new Slope(height + fall * (fallX * x + fallY * y), -fall * fallX, -fall * fallY);
        }

        double at(double x, double y) {
            return base + east * x + north * y;
        }

        private boolean isSame(Slope other) {
            return Math.abs(base - other.base) < SAME
                    && Math.abs(east - other.east) < SAME
                    && Math.abs(north - other.north) < SAME;
        }
    }

    /**
     * The roof of a building. All coordinates are relative to a point near the building, lest differences of large
     * numbers cost precision.
     *
     * @param outer the outline, counter-clockwise
     * @param dimensions dimensions of a building whose roof is not flat
     */
    static RoofPlanes of(double[] outer, Dimensions dimensions) {
        Rectangle rectangle = rectangle(outer, dimensions.direction(), dimensions.isAcross());
        double rise = dimensions.rise();
        List<Slope> all =
                switch (dimensions.roof()) {
                    case GABLED -> sides(rectangle, rise, rectangle.halfWidth(), false);
                    case HIPPED ->
                        sides(rectangle, rise, Math.min(rectangle.halfWidth(), rectangle.halfLength()), true);
                    case PYRAMIDAL ->
                        aboutMiddle(outer, rectangle, rise, new double[] {1.0, 0.0}, new double[] {0.0, 1.0});
                    case DOME -> dome(outer, rectangle, rise);
                    case SKILLION -> List.of(skillion(outer, rectangle, rise, dimensions.direction()));
                    case FLAT -> throw new IllegalArgumentException("a flat roof has no slopes");
                };
        List<Slope> different = new ArrayList<>();
        for (Slope slope : all) {
            if (different.stream().noneMatch(slope::isSame)) {
                different.add(slope);
            }
        }
        return new RoofPlanes(different);
    }

    /** The rectangle whose first side the ridge runs along. */
    static Rectangle rectangle(double[] outer, OptionalDouble direction, boolean isAcross) {
        if (direction.isPresent()) {
            double down = direction.getAsDouble();
            // The ridge is at right angles to the way down.
            return Rectangle.about(outer, Math.cos(down), -Math.sin(down));
        }
        Rectangle about = Rectangle.about(outer);
        return isAcross ? about.turned() : about;
    }

    private static List<Slope> sides(Rectangle about, double rise, double run, boolean hasHips) {
        List<Slope> slopes = new ArrayList<>();
        double fall = rise / run;
        for (int side = -1; side <= 1; side += 2) {
            double x = -side * about.alongY();
            double y = side * about.alongX();
            slopes.add(Slope.through(
                    about.x() + about.halfWidth() * x, about.y() + about.halfWidth() * y, 0.0, x, y, fall));
            if (hasHips) {
                x = side * about.alongX();
                y = side * about.alongY();
                slopes.add(Slope.through(
                        about.x() + about.halfLength() * x, about.y() + about.halfLength() * y, 0.0, x, y, fall));
            }
        }
        return slopes;
    }

    /**
     * Slopes from each side to the middle, where the distance from the side is a fraction of that in the middle, 1 at
     * the side and 0 in the middle; the height is a curve over that fraction, given by its corners.
     */
    private static List<Slope> aboutMiddle(
            double[] outer, Rectangle rectangle, double rise, double[] fractions, double[] heights) {
        double[] ring = Rings.isConvex(outer) ? outer : rectangle.ring();
        double[] middle = centroid(ring);
        List<Slope> slopes = new ArrayList<>();
        int last = ring.length - 2;
        for (int i = 0; i < ring.length; i += 2) {
            double length = Math.hypot(ring[i] - ring[last], ring[i + 1] - ring[last + 1]);
            // Outwards, as corners run counter-clockwise.
            double x = (ring[i + 1] - ring[last + 1]) / length;
            double y = -(ring[i] - ring[last]) / length;
            double run = (ring[i] - middle[0]) * x + (ring[i + 1] - middle[1]) * y;
            for (int k = 0; k + 1 < fractions.length; k++) {
                double steep = rise * (heights[k + 1] - heights[k]) / (fractions[k] - fractions[k + 1]);
                double inMiddle = rise * heights[k] + steep * fractions[k];
                slopes.add(Slope.through(middle[0], middle[1], inMiddle, x, y, steep / run));
            }
            last = i;
        }
        return slopes;
    }

    private static List<Slope> dome(double[] outer, Rectangle rectangle, double rise) {
        double[] fractions = new double[RINGS_OF_A_DOME + 1];
        double[] heights = new double[RINGS_OF_A_DOME + 1];
        for (int k = 0; k <= RINGS_OF_A_DOME; k++) {
            double angle = 0.5 * Math.PI * k / RINGS_OF_A_DOME;
            fractions[k] = Math.cos(angle);
            heights[k] = Math.sin(angle);
        }
        return aboutMiddle(outer, rectangle, rise, fractions, heights);
    }

    private static Slope skillion(double[] outer, Rectangle about, double rise, OptionalDouble direction) {
        double x = -about.alongY();
        double y = about.alongX();
        // Where the map does not say which way it slopes, it is the more southern one.
        boolean isTurned = direction.isPresent()
                ? x * Math.sin(direction.getAsDouble()) + y * Math.cos(direction.getAsDouble()) < 0.0
                : y > 0.0 || y == 0.0 && x > 0.0;
        double side = isTurned ? -1.0 : 1.0;
        return Slope.through(
                about.x() + side * about.halfWidth() * x,
                about.y() + side * about.halfWidth() * y,
                0.0,
                side * x,
                side * y,
                rise / (2.0 * about.halfWidth()));
    }

    static double[] centroid(double[] ring) {
        double twice = 0.0;
        double x = 0.0;
        double y = 0.0;
        int last = ring.length - 2;
        for (int i = 0; i < ring.length; i += 2) {
            double cross =
                    (ring[last] - ring[0]) * (ring[i + 1] - ring[1]) - (ring[i] - ring[0]) * (ring[last + 1] - ring[1]);
            twice += cross;
            x += cross * (ring[last] + ring[i] - 2.0 * ring[0]);
            y += cross * (ring[last + 1] + ring[i + 1] - 2.0 * ring[1]);
            last = i;
        }
        return new double[] {ring[0] + x / (3.0 * twice), ring[1] + y / (3.0 * twice)};
    }

    /** The height over the eaves at a point, m. */
    double at(double x, double y) {
        double lowest = Double.POSITIVE_INFINITY;
        for (Slope slope : planes) {
            lowest = Math.min(lowest, slope.at(x, y));
        }
        return Math.max(0.0, lowest);
    }

    /** The part of an outline over which each plane is the lowest, in their order; empty where one never is. */
    List<double[]> pieces(double[] outer) {
        List<double[]> pieces = new ArrayList<>();
        for (Slope own : planes) {
            double[] piece = outer;
            for (Slope other : planes) {
                if (other != own && piece.length > 0) {
                    piece = Rings.clipped(piece, own.east - other.east, own.north - other.north, other.base - own.base);
                }
            }
            pieces.add(Rings.cleaned(piece, SAME));
        }
        return pieces;
    }

    /** Where along a line from one point to another the lowest plane changes, as fractions of the line, in order. */
    double[] breaks(double fromX, double fromY, double toX, double toY) {
        List<Double> breaks = new ArrayList<>();
        double at = 0.0;
        Slope current = lowest(fromX, fromY, toX, toY);
        while (true) {
            double start = current.at(fromX, fromY);
            double climb = current.at(toX, toY) - start;
            double next = 1.0;
            Slope following = null;
            for (Slope other : planes) {
                double steeper = climb - (other.at(toX, toY) - other.at(fromX, fromY));
                if (other != current && steeper > SAME) {
                    double crossing = (other.at(fromX, fromY) - start) / steeper;
                    if (crossing < next && crossing >= at) {
                        next = crossing;
                        following = other;
                    }
                }
            }
            if (following == null) {
                return breaks.stream().mapToDouble(Double::doubleValue).toArray();
            }
            if (next > SAME && next < 1.0 - SAME) {
                breaks.add(next);
            }
            at = next;
            current = following;
        }
    }

    /** The lowest plane just after the first of two points. */
    private Slope lowest(double fromX, double fromY, double toX, double toY) {
        Slope lowest = planes.get(0);
        for (Slope other : planes) {
            double less = lowest.at(fromX, fromY) - other.at(fromX, fromY);
            double climbs = lowest.at(toX, toY) - other.at(toX, toY);
            if (less > SAME || less > -SAME && climbs > SAME) {
                lowest = other;
            }
        }
        return lowest;
    }
}
