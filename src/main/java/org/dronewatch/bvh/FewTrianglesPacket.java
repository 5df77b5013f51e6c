package org.dronewatch.bvh;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;
import org.dronewatch.kdtree.LeafOrderTriangles;
import org.dronewatch.kdtree.RayTracer;

/**
 * Traces four rays against each of a few triangles, one ray in each lane of a vector, by the arithmetic of
 * {@code TriangleIntersection}. A corner is sheared once for all triangles that share it. Rays for which rounding or
 * equal distances matter are traced again, one by one.
 */
final class FewTrianglesPacket extends RayPacket {
    private static final VectorSpecies<Double> DOUBLES = DoubleVector.SPECIES_256;
    private static final VectorSpecies<Long> LONGS = LongVector.SPECIES_256;

    /** The last bits of a key are the triangle's index: keys that differ only there are equally near. */
    private static final int INDEX_BITS = 4;

    private static final long INDEX = (1L << INDEX_BITS) - 1L;
    private static final long WITHOUT_INDEX = ~INDEX;

    /** Numbers of a corner: x, y and z in the order for each ray's axis, four lanes each. */
    private static final int CORNER = 3 * RAYS;

    /** The smallest parameter that counts is 0. */
    private static final double BELOW = -Double.MIN_VALUE;

    private final RayTracer one;
    private final CornerTable table;
    private final int[] triangles;
    private final double[] corners;

    /** Corners relative to the sheared rays. */
    private final double[] sheared;

    /**
     * Coordinates of origins and directions in the order for each ray's axis, lane by lane, and after them one over the
     * largest component.
     */
    private final double[] lanes = new double[7 * RAYS];

    private final int[] axes = {-1, -1, -1, -1};

    /** Parameters at which the rays meet the planes of the triangles. */
    private final double[] parameters = new double[FewTriangles.MOST * RAYS];

    /** As in {@link FewTrianglesTraversal}: the nearer, the larger; negative where all are missed. */
    private final long[] nearest = new long[RAYS];

    private final long[] second = new long[RAYS];

    /** For each ray the smallest absolute product of a triangle's edge functions, as bits. */
    private final long[] edges = new long[RAYS];

    FewTrianglesPacket(LeafOrderTriangles inLeafOrder, RayTracer one) {
        super(inLeafOrder.numbers());
        this.one = one;
        this.table = new CornerTable(inLeafOrder.corners());
        this.triangles = table.triangles(CORNER);
        this.corners = new double[CORNER * table.count()];
        this.sheared = new double[CORNER * table.count()];
        for (int ray = 0; ray < RAYS; ray++) {
            set(ray, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0);
        }
    }

    @Override
    public void set(int ray, double ox, double oy, double oz, double dx, double dy, double dz) {
        double x = Math.abs(dx);
        double y = Math.abs(dy);
        double z = Math.abs(dz);
        // As TriangleIntersection chooses the axis. It seldom changes: most rays are reflected specularly.
        if (x > y && x > z) {
            turn(ray, 0);
            set(ray, oy, oz, ox);
            setDirection(ray, dy, dz, dx);
        } else if (!(x > y) && y > z) {
            turn(ray, 1);
            set(ray, oz, ox, oy);
            setDirection(ray, dz, dx, dy);
        } else {
            turn(ray, 2);
            set(ray, ox, oy, oz);
            setDirection(ray, dx, dy, dz);
        }
    }

    private void turn(int ray, int kz) {
        if (axes[ray] != kz) {
            axes[ray] = kz;
            table.fill(corners, ray, RAYS, kz);
        }
    }

    private void set(int ray, double x, double y, double z) {
        lanes[ray] = x;
        lanes[RAYS + ray] = y;
        lanes[2 * RAYS + ray] = z;
    }

    private void setDirection(int ray, double x, double y, double z) {
        lanes[3 * RAYS + ray] = x;
        lanes[4 * RAYS + ray] = y;
        lanes[5 * RAYS + ray] = z;
    }

    /** A number of a ray, which is not turned: 0 to 2 for its origin, 3 to 5 for its direction. */
    private double number(int ray, int index) {
        int place = (index % 3 + 2 - axes[ray]) % 3;
        return lanes[(index / 3 * 3 + place) * RAYS + ray];
    }

    @Override
    public void trace(int count) {
        if (count == 1) {
            // Four triangles at once are faster than four rays.
            traceAlone(0);
            return;
        }
        shear();
        test();
        for (int ray = 0; ray < count; ray++) {
            long key = nearest[ray];
            int index = (int) (key & INDEX);
            double parameter = parameters[RAYS * index + ray];
            if (edges[ray] == 0L || key >= 0L && (isTie(key, second[ray]) || !(parameter >= 0.0))) {
                traceAlone(ray);
            } else {
                keep(ray, key >= 0L, index, parameter);
            }
        }
    }

    private static boolean isTie(long key, long next) {
        return (key ^ next) >>> INDEX_BITS == 0L;
    }

    private void traceAlone(int ray) {
        boolean hit = one.closestHit(
                number(ray, 0),
                number(ray, 1),
                number(ray, 2),
                number(ray, 3),
                number(ray, 4),
                number(ray, 5),
                0.0,
                Double.POSITIVE_INFINITY);
        keep(ray, hit, one);
    }

    private void shear() {
        double[] from = corners;
        double[] to = sheared;
        DoubleVector originX = load(lanes, 0);
        DoubleVector originY = load(lanes, RAYS);
        DoubleVector originZ = load(lanes, 2 * RAYS);
        DoubleVector directionZ = load(lanes, 5 * RAYS);
        DoubleVector shearX = load(lanes, 3 * RAYS).div(directionZ);
        DoubleVector shearY = load(lanes, 4 * RAYS).div(directionZ);
        DoubleVector.broadcast(DOUBLES, 1.0).div(directionZ).intoArray(lanes, 6 * RAYS);
        for (int at = 0; at < from.length; at += CORNER) {
            DoubleVector z = load(from, at + 2 * RAYS).sub(originZ);
            load(from, at).sub(originX).sub(z.mul(shearX)).intoArray(to, at);
            load(from, at + RAYS).sub(originY).sub(z.mul(shearY)).intoArray(to, at + RAYS);
            z.intoArray(to, at + 2 * RAYS);
        }
    }

    /** Apart from {@link #shear}: the compiler keeps the vectors of one loop in registers, not those of two. */
    private void test() {
        double[] c = sheared;
        double[] ts = parameters;
        int[] offsets = triangles;
        DoubleVector shearZ = load(lanes, 6 * RAYS);
        DoubleVector zero = DoubleVector.zero(DOUBLES);
        LongVector best = LongVector.broadcast(LONGS, Long.MIN_VALUE);
        LongVector next = LongVector.broadcast(LONGS, Long.MIN_VALUE);
        LongVector least = LongVector.broadcast(LONGS, Long.MAX_VALUE);
        int index = 0;
        for (int i = 0; i < offsets.length; i += 3) {
            int first = offsets[i];
            int middle = offsets[i + 1];
            int last = offsets[i + 2];
            DoubleVector ax = load(c, first);
            DoubleVector ay = load(c, first + RAYS);
            DoubleVector bx = load(c, middle);
            DoubleVector by = load(c, middle + RAYS);
            DoubleVector cx = load(c, last);
            DoubleVector cy = load(c, last + RAYS);

            // As in FewTrianglesTraversal: the sign bit is set where the triangle is missed.
            DoubleVector a = cx.mul(by).sub(cy.mul(bx));
            DoubleVector b = ax.mul(cy).sub(ay.mul(cx));
            DoubleVector g = bx.mul(ay).sub(by.mul(ax));
            DoubleVector product = a.fma(b, zero);
            LongVector missed = product.reinterpretAsLongs()
                    .or(b.fma(g, zero).reinterpretAsLongs())
                    .or(g.fma(a, zero).reinterpretAsLongs());
            least = least.min(product.mul(g).reinterpretAsLongs().and(Long.MAX_VALUE));
            DoubleVector t = a.mul(load(c, first + 2 * RAYS))
                    .add(b.mul(load(c, middle + 2 * RAYS)))
                    .add(g.mul(load(c, last + 2 * RAYS)))
                    .div(a.add(b).add(g))
                    .mul(shearZ);
            t.intoArray(ts, RAYS * index);
            LongVector key = t.add(zero)
                    .reinterpretAsLongs()
                    .lanewise(VectorOperators.XOR, Long.MAX_VALUE)
                    .or(missed.or(t.sub(BELOW).reinterpretAsLongs()).and(Long.MIN_VALUE))
                    .and(WITHOUT_INDEX)
                    .or((long) index);
            next = next.max(best.min(key));
            best = best.max(key);
            index++;
        }
        best.intoArray(nearest, 0);
        next.intoArray(second, 0);
        least.intoArray(edges, 0);
    }

    private static DoubleVector load(double[] values, int at) {
        return DoubleVector.fromArray(DOUBLES, values, at);
    }
}
