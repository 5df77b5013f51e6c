package org.dronewatch.drone.silhouette;

import java.util.Arrays;
import org.dronewatch.geometry.TriangleMesh;

/**
 * Draws the masks of a mesh. The mesh is projected orthographically as seen from the middle of a range of directions.
 * As seen from any other direction of the range, and in perspective, each of its points appears displaced by no more
 * than a bound that is computed for each vertex.
 *
 * <p>A point that is farther than this bound from every covered point remains uncovered. A covered point, however, may
 * become uncovered even if everything around it is covered: a gap may open between two parts of a drone, one of which
 * is behind the other. Therefore each connected part is considered alone. Its triangles, each oriented so that it faces
 * the camera, form a surface; the number of times that this surface covers a point is the winding number of its outline
 * about the point, and remains the same as long as the outline does not pass over the point. The outline consists of
 * the edges at which the triangles do not cancel: those where the surface turns away, and those with a triangle on one
 * side only. So a covered point that is farther than the bound from the outline of a part remains covered by it. This
 * holds for any mesh, closed or not.
 *
 * <p>Immutable and thread-safe.
 */
final class SilhouetteRaster {
    private static final int TEXELS = SilhouetteMask.TEXELS;

    /** The least distance of the camera in radii: perspective displaces points by at most 1/126 radius. */
    private static final double MIN_RANGE = 64.0;

    /** Tolerance for rounding, as a fraction of the radius. */
    private static final double SLACK = 1e-6;

    private static final double EDGE_TOLERANCE = 1e-13;

    private final MeshParts parts;
    private final double radius;
    private final double halfWidth;
    private final double texel;

    SilhouetteRaster(TriangleMesh mesh) {
        this.parts = new MeshParts(mesh);
        this.radius = Math.max(mesh.radius(), Double.MIN_NORMAL);
        // Perspective magnifies whatever is nearer than the origin.
        this.halfWidth = radius * (1.0 + 1.0 / MIN_RANGE);
        this.texel = 2.0 * halfWidth / TEXELS;
    }

    double radius() {
        return radius;
    }

    double halfWidth() {
        return halfWidth;
    }

    double minRange() {
        return MIN_RANGE * radius;
    }

    /**
     * The mask for a range of directions.
     *
     * @param azimuth azimuth of the middle of the range, relative to the drone's nose, clockwise, rad
     * @param elevation elevation of the middle of the range, rad
     * @param aside half the range of azimuths, rad
     * @param above half the range of elevations, rad
     */
    SilhouetteMask mask(double azimuth, double elevation, double aside, double above) {
        return new SilhouetteMask(new Drawing(azimuth, elevation, aside, above).kinds());
    }

    /** The drawing of one mask. Coordinates are in texels from the lower left corner of the mask. */
    private final class Drawing {
        private final float[] points = parts.points();
        private final double[] x = new double[points.length / 3];
        private final double[] y = new double[x.length];
        private final double[] shift = new double[x.length];
        private final byte[] coefficients = new byte[parts.edgeCount()];
        private final boolean[] covered = new boolean[TEXELS * TEXELS];
        private final boolean[] near = new boolean[TEXELS * TEXELS];
        private final byte[] kinds = new byte[TEXELS * TEXELS];

        private int left;
        private int right;
        private int bottom;
        private int top;

        Drawing(double azimuth, double elevation, double aside, double above) {
            double sinA = Math.sin(azimuth);
            double cosA = Math.cos(azimuth);
            double sinE = Math.sin(elevation);
            double cosE = Math.cos(elevation);
            double curved = 0.75 * (aside + above) * (aside + above) * radius;
            for (int i = 0; i < x.length; i++) {
                double px = points[3 * i];
                double py = points[3 * i + 1];
                double pz = points[3 * i + 2];
                double level = px * sinA + py * cosA;
                double across = px * cosA - py * sinA;
                double depth = level * cosE + pz * sinE;
                // The displacement of a vertex, to the side and upwards, with azimuth and elevation: first to first
                // order, then the rest.
                double first =
                        length(Math.abs(level) * aside, Math.abs(across * sinE) * aside + Math.abs(depth) * above);
                double perspective = 0.5 * (px * px + py * py + pz * pz) / ((MIN_RANGE - 1.0) * radius);
                x[i] = (across + halfWidth) / texel;
                y[i] = (pz * cosE - level * sinE + halfWidth) / texel;
                shift[i] = (first + curved + perspective + SLACK * radius) / texel;
            }
        }

        byte[] kinds() {
            for (int part = 0; part < parts.count(); part++) {
                draw(part);
            }
            return kinds;
        }

        private void draw(int part) {
            setRegion(part);
            for (int row = bottom; row <= top; row++) {
                Arrays.fill(covered, row * TEXELS + left, row * TEXELS + right + 1, false);
                Arrays.fill(near, row * TEXELS + left, row * TEXELS + right + 1, false);
            }
            for (int triangle = parts.firstTriangle(part); triangle < parts.firstTriangle(part + 1); triangle++) {
                cover(triangle);
            }
            for (int edge = parts.firstEdge(part); edge < parts.firstEdge(part + 1); edge++) {
                if (coefficients[edge] != 0) {
                    outline(parts.edgeStart(edge), parts.edgeEnd(edge));
                }
            }
            addPart();
        }

        /** Sets the range of texels that a part may change. */
        private void setRegion(int part) {
            double x0 = TEXELS;
            double x1 = 0.0;
            double y0 = TEXELS;
            double y1 = 0.0;
            for (int edge = parts.firstEdge(part); edge < parts.firstEdge(part + 1); edge++) {
                int point = parts.edgeStart(edge);
                int other = parts.edgeEnd(edge);
                double rim = Math.max(shift[point], shift[other]) + 2.0;
                x0 = Math.min(x0, Math.min(x[point], x[other]) - rim);
                x1 = Math.max(x1, Math.max(x[point], x[other]) + rim);
                y0 = Math.min(y0, Math.min(y[point], y[other]) - rim);
                y1 = Math.max(y1, Math.max(y[point], y[other]) + rim);
            }
            left = texelOf(x0);
            right = texelOf(x1);
            bottom = texelOf(y0);
            top = texelOf(y1);
        }

        private static int texelOf(double coordinate) {
            return (int) Math.max(0.0, Math.min(TEXELS - 1.0, Math.floor(coordinate)));
        }

        /** Marks the texels whose centres a triangle covers, and adds its edges to the outline. */
        private void cover(int triangle) {
            int a = parts.corner(triangle, 0);
            int b = parts.corner(triangle, 1);
            int c = parts.corner(triangle, 2);
            double twiceArea = (x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a]);
            int sign = twiceArea >= 0.0 ? 1 : -1;
            boolean isSliver = Math.abs(twiceArea) < SLACK * TEXELS * longest(a, b, c);
            for (int side = 0; side < 3; side++) {
                int edge = parts.edge(triangle, side);
                coefficients[edge] = isSliver
                        ? MeshParts.ALWAYS
                        : MeshParts.sum(coefficients[edge], sign * parts.direction(triangle, side));
            }
            if (!isSliver) {
                fill(a, sign > 0 ? b : c, sign > 0 ? c : b);
            }
        }

        private static double length(double dx, double dy) {
            return Math.sqrt(dx * dx + dy * dy);
        }

        private double longest(int a, int b, int c) {
            return Math.max(
                    length(x[b] - x[a], y[b] - y[a]),
                    Math.max(length(x[c] - x[b], y[c] - y[b]), length(x[a] - x[c], y[a] - y[c])));
        }

        private void fill(int a, int b, int c) {
            // Many triangles are smaller than a texel, and contain no centre.
            int x0 = texelOf(Math.ceil(Math.min(x[a], Math.min(x[b], x[c])) - 0.5 - SLACK));
            int x1 = texelOf(Math.max(x[a], Math.max(x[b], x[c])) - 0.5 + SLACK);
            int y0 = texelOf(Math.ceil(Math.min(y[a], Math.min(y[b], y[c])) - 0.5 - SLACK));
            int y1 = texelOf(Math.max(y[a], Math.max(y[b], y[c])) - 0.5 + SLACK);
            for (int row = y0; row <= y1; row++) {
                for (int column = x0; column <= x1; column++) {
                    if (isLeft(a, b, column, row) && isLeft(b, c, column, row) && isLeft(c, a, column, row)) {
                        covered[row * TEXELS + column] = true;
                    }
                }
            }
        }

        /** Whether a texel's centre is to the left of an edge or, apart from rounding, on it. */
        private boolean isLeft(int from, int to, int column, int row) {
            double dx = x[to] - x[from];
            double dy = y[to] - y[from];
            return dx * (row + 0.5 - y[from]) - dy * (column + 0.5 - x[from])
                    >= -EDGE_TOLERANCE * TEXELS * (Math.abs(dx) + Math.abs(dy));
        }

        /** Marks the texels that may have a point within the bound of an edge. */
        private void outline(int from, int to) {
            double reach = Math.max(shift[from], shift[to]) + Math.sqrt(0.5);
            int x0 = texelOf(Math.min(x[from], x[to]) - reach - 0.5);
            int x1 = texelOf(Math.max(x[from], x[to]) + reach);
            int y0 = texelOf(Math.min(y[from], y[to]) - reach - 0.5);
            int y1 = texelOf(Math.max(y[from], y[to]) + reach);
            double dx = x[to] - x[from];
            double dy = y[to] - y[from];
            double square = Math.max(dx * dx + dy * dy, Double.MIN_NORMAL);
            for (int row = y0; row <= y1; row++) {
                for (int column = x0; column <= x1; column++) {
                    if (near[row * TEXELS + column]) {
                        continue;
                    }
                    double px = column + 0.5 - x[from];
                    double py = row + 0.5 - y[from];
                    double along = Math.max(0.0, Math.min(1.0, (px * dx + py * dy) / square));
                    double ex = px - along * dx;
                    double ey = py - along * dy;
                    if (ex * ex + ey * ey <= reach * reach) {
                        near[row * TEXELS + column] = true;
                    }
                }
            }
        }

        private void addPart() {
            for (int row = bottom; row <= top; row++) {
                for (int texel = row * TEXELS + left; texel <= row * TEXELS + right; texel++) {
                    byte kind = covered[texel]
                            ? near[texel] ? SilhouetteMask.LIKELY : SilhouetteMask.INSIDE
                            : near[texel] ? SilhouetteMask.UNLIKELY : SilhouetteMask.OUTSIDE;
                    kinds[texel] = (byte) Math.max(kinds[texel], kind);
                }
            }
        }
    }
}
