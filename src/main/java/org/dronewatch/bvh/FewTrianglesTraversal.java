package org.dronewatch.bvh;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;
import org.dronewatch.kdtree.LeafOrderTriangles;
import org.dronewatch.kdtree.RayTracer;

/**
 * Tests every one of a few triangles, four at once, by the arithmetic of {@code TriangleIntersection}, and without a
 * branch: which wall of a room a ray hits cannot be predicted, and a wrong guess costs as much as testing another four.
 * It hits what the kd-tree hits; where triangles meet at the very point that a ray hits, it chooses among them as
 * {@link BvhTraversal} does.
 */
final class FewTrianglesTraversal extends RayTracer {
    private static final VectorSpecies<Double> DOUBLES = DoubleVector.SPECIES_256;
    private static final VectorSpecies<Long> LONGS = LongVector.SPECIES_256;
    private static final int LANES = FewTriangles.LANES;
    private static final int CORNER = FewTriangles.CORNER;

    private final FewTriangles triangles;
    private final double[] coordinates;
    private final double[] parameters = new double[FewTriangles.MOST];
    private final double[] edgeProducts = new double[FewTriangles.MOST];

    /** For each triangle: the nearer it is hit, the larger; negative where it is missed. */
    private final long[] keys = new long[FewTriangles.MOST];

    private int axis;
    private int winner;

    FewTrianglesTraversal(LeafOrderTriangles inLeafOrder, FewTriangles triangles) {
        super(inLeafOrder);
        this.triangles = triangles;
        this.coordinates = triangles.coordinates();
    }

    @Override
    protected void trace(double tMin, double tMax, boolean anyHit) {
        double x = Math.abs(direction[0]);
        double y = Math.abs(direction[1]);
        double z = Math.abs(direction[2]);
        int kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        int kx = kz == 2 ? 0 : kz + 1;
        int ky = kx == 2 ? 0 : kx + 1;
        axis = kz;
        long nearest = test(
                triangles.first(kz),
                origin[kx],
                origin[ky],
                origin[kz],
                direction[kx] / direction[kz],
                direction[ky] / direction[kz],
                1.0 / direction[kz],
                Math.nextDown(tMin));
        if (nearest < 0L) {
            return;
        }
        int hits = lanesOf(nearest);
        int lane = Integer.numberOfTrailingZeros(hits);
        double parameter = parameters[lane];
        if ((hits & hits - 1) != 0 || edgeProducts[lane] == 0.0 || !(parameter >= tMin)) {
            choose(tMin, tMax);
        } else if (parameter <= tMax) {
            winner = lane;
            setHit(triangles.number(lane), parameter);
        }
    }

    /**
     * Tests all triangles; the arguments are the ray in the form of the test.
     *
     * @param first index of the first block
     * @param below hits up to this parameter do not count
     * @return the largest key
     */
    private long test(
            int first,
            double originX,
            double originY,
            double originZ,
            double shearX,
            double shearY,
            double shearZ,
            double below) {
        double[] c = coordinates;
        double[] ts = parameters;
        double[] zeros = edgeProducts;
        long[] order = keys;
        DoubleVector zero = DoubleVector.zero(DOUBLES);
        LongVector best = LongVector.broadcast(LONGS, Long.MIN_VALUE);
        int at = first;
        int lanes = triangles.lanes();
        for (int lane = 0; lane < lanes; lane += LANES) {
            // The corners relative to the sheared ray, as in TriangleIntersection, of four triangles.
            DoubleVector az = load(c, at + 2 * LANES).sub(originZ);
            DoubleVector bz = load(c, at + CORNER + 2 * LANES).sub(originZ);
            DoubleVector cz = load(c, at + 2 * CORNER + 2 * LANES).sub(originZ);
            DoubleVector ax = load(c, at).sub(originX).sub(az.mul(shearX));
            DoubleVector ay = load(c, at + LANES).sub(originY).sub(az.mul(shearY));
            DoubleVector bx = load(c, at + CORNER).sub(originX).sub(bz.mul(shearX));
            DoubleVector by = load(c, at + CORNER + LANES).sub(originY).sub(bz.mul(shearY));
            DoubleVector cx = load(c, at + 2 * CORNER).sub(originX).sub(cz.mul(shearX));
            DoubleVector cy = load(c, at + 2 * CORNER + LANES).sub(originY).sub(cz.mul(shearY));

            // The edge functions. Where two have opposite signs, their product has the sign bit: the triangle is
            // missed. The zero that is added turns -0 into 0, which counts as inside.
            DoubleVector a = cx.mul(by).sub(cy.mul(bx));
            DoubleVector b = ax.mul(cy).sub(ay.mul(cx));
            DoubleVector g = bx.mul(ay).sub(by.mul(ax));
            LongVector missed = a.fma(b, zero)
                    .reinterpretAsLongs()
                    .or(b.fma(g, zero).reinterpretAsLongs())
                    .or(g.fma(a, zero).reinterpretAsLongs());
            DoubleVector t =
                    a.mul(az).add(b.mul(bz)).add(g.mul(cz)).div(a.add(b).add(g)).mul(shearZ);

            // The bits of positive numbers are ordered as the numbers are. NaN, of triangles without area, is last.
            LongVector key = t.add(zero)
                    .reinterpretAsLongs()
                    .lanewise(VectorOperators.XOR, Long.MAX_VALUE)
                    .or(missed.or(t.sub(below).reinterpretAsLongs()).and(Long.MIN_VALUE));
            t.intoArray(ts, lane);
            a.mul(b).mul(g).intoArray(zeros, lane);
            key.intoArray(order, lane);
            best = best.max(key);
            at += FewTriangles.BLOCK;
        }
        return best.reduceLanes(VectorOperators.MAX);
    }

    private static DoubleVector load(double[] values, int at) {
        return DoubleVector.fromArray(DOUBLES, values, at);
    }

    /** A bit for each triangle with a key. */
    private int lanesOf(long key) {
        int hits = 0;
        for (int lane = 0; lane < triangles.lanes(); lane++) {
            // Without a branch: where the difference is zero, it alone has no sign bit, but one less has.
            long difference = keys[lane] ^ key;
            hits |= (int) ((difference - 1L & ~difference) >>> Long.SIZE - 1) << lane;
        }
        return hits;
    }

    /**
     * Chooses among equally near hits, and among hits of edges: only where an edge function is zero can the ray be
     * beside a triangle that it seems to hit.
     */
    private void choose(double tMin, double tMax) {
        double nearest = tMax;
        int triangle = -1;
        for (int lane = 0; lane < triangles.lanes(); lane++) {
            double parameter = parameters[lane];
            int number = triangles.number(lane);
            if (keys[lane] >= 0L
                    && parameter >= tMin
                    && (parameter < nearest || parameter == nearest && (triangle < 0 || number < triangle))
                    && !(edgeProducts[lane] == 0.0 && isBeside(lane))) {
                nearest = parameter;
                triangle = number;
                winner = lane;
            }
        }
        if (triangle >= 0) {
            setHit(triangle, nearest);
        }
    }

    private boolean isBeside(int lane) {
        return isBeside(
                sheared(lane, 0, 0),
                sheared(lane, 0, 1),
                sheared(lane, 1, 0),
                sheared(lane, 1, 1),
                sheared(lane, 2, 0),
                sheared(lane, 2, 1));
    }

    /** A coordinate, 0 or 1, of a triangle's corner relative to the sheared ray. */
    private double sheared(int lane, int corner, int coordinate) {
        int other = (axis + 1 + coordinate) % 3;
        return triangles.coordinate(axis, lane, 3 * corner + coordinate)
                - origin[other]
                - direction[other] / direction[axis] * along(lane, corner);
    }

    /** A corner's coordinate along the axis, from the ray's origin. */
    private double along(int lane, int corner) {
        return triangles.coordinate(axis, lane, 3 * corner + 2) - origin[axis];
    }

    @Override
    protected void findBarycentrics() {
        double ax = sheared(winner, 0, 0);
        double ay = sheared(winner, 0, 1);
        double bx = sheared(winner, 1, 0);
        double by = sheared(winner, 1, 1);
        double cx = sheared(winner, 2, 0);
        double cy = sheared(winner, 2, 1);
        double a = cx * by - cy * bx;
        double b = ax * cy - ay * cx;
        double g = bx * ay - by * ax;
        double determinant = a + b + g;
        setBarycentrics(b / determinant, g / determinant);
    }
}
