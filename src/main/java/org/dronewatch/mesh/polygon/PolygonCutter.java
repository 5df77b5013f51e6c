package org.dronewatch.mesh.polygon;

import java.util.List;
import org.dronewatch.geometry.Floats;
import org.dronewatch.geometry.Ints;
import org.maplibre.earcut4j.Earcut;

/**
 * Cuts polygons into triangles with the winding of the polygon. A polygon of at most {@value #MOST_CORNERS_OF_A_FAN}
 * corners that is visible as a whole from its first corner, such as a convex one, is cut into a fan from there; any
 * other that does not cross itself is cut by ear clipping in its plane.
 */
public final class PolygonCutter {
    /**
     * Maximum number of corners of a fan. All of its triangles meet in one corner, where no tree separates them: a ray
     * through a circle costs twice as much with a fan as with clipped ears at 256 corners, and ten times as much at
     * 4,000.
     */
    static final int MOST_CORNERS_OF_A_FAN = 256;

    private final Floats vertices;

    /**
     * A cutter of polygons.
     *
     * @param vertices x, y and z of each vertex in turn, m; may grow later
     */
    public PolygonCutter(Floats vertices) {
        this.vertices = vertices;
    }

    /**
     * Appends the corners of the triangles: at most n - 2 triangles for a polygon of n corners.
     *
     * @param polygon vertex indices of its corners in turn, 3 or more
     * @param target receives the three vertex indices of each triangle
     * @return whether the triangles cover the polygon; false for one that crosses itself, which is cut into a fan all
     *     the same
     */
    public boolean cut(int[] polygon, Ints target) {
        if (polygon.length == 3) {
            fan(polygon, target);
            return true;
        }
        FlatPolygon flat = new FlatPolygon(vertices, polygon);
        if (flat.isWithoutPlane()) {
            fan(polygon, target);
            return flat.isThin();
        }
        boolean fanCovers = flat.isSeenFromItsFirstCorner();
        boolean earsFirst = !fanCovers || polygon.length > MOST_CORNERS_OF_A_FAN;
        if (earsFirst && SelfContacts.allowEars(flat) && clipEars(flat, polygon, target)) {
            return true;
        }
        fan(polygon, target);
        return fanCovers || flat.isThin();
    }

    private static void fan(int[] polygon, Ints target) {
        for (int i = 1; i + 1 < polygon.length; i++) {
            target.add(polygon[0]);
            target.add(polygon[i]);
            target.add(polygon[i + 1]);
        }
    }

    /** Appends nothing and returns false when the ears do not have the polygon's area. */
    private static boolean clipEars(FlatPolygon flat, int[] polygon, Ints target) {
        List<Integer> ears = Earcut.earcut(flat.coordinates());
        double area = 0.0;
        for (int i = 0; i < ears.size(); i += 3) {
            area += Math.abs(flat.doubleArea(ears.get(i), ears.get(i + 1), ears.get(i + 2)));
        }
        if (Math.abs(area - flat.doubleArea()) > FlatPolygon.NEGLIGIBLE * flat.doubleArea()) {
            return false;
        }
        ears.forEach(corner -> target.add(polygon[corner]));
        return true;
    }
}
