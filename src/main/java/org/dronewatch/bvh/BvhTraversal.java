package org.dronewatch.bvh;

import jdk.incubator.vector.ByteVector;
import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.kdtree.RayTracer;
import org.dronewatch.kdtree.StackTraversal;

/**
 * Walks a {@link Bvh}: a step tests the boxes of eight children at once in single precision, widened by more than the
 * rounding errors; a block tests four triangles at once, in double precision by the arithmetic of
 * {@code TriangleIntersection}. It hits what the kd-tree hits; where triangles meet at the very point that a ray hits,
 * it reports the nearest, even if only the last bit differs; of equally near ones, the one with the lowest number.
 *
 * <p>For incoherent rays: in a kd-tree they take many narrow steps, and processors mispredict half of them. Rays whose
 * numbers cannot be bounded in single precision are left to the kd-tree.
 *
 * <p>The code keeps to what the just-in-time compiler turns into plain vector instructions: no masks, no vectors passed
 * from method to method, and a separate method for leaves.
 */
final class BvhTraversal extends RayTracer {
    private static final VectorSpecies<Integer> INTS_8 = IntVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS_4 = IntVector.SPECIES_128;
    private static final VectorSpecies<Float> FLOATS_8 = FloatVector.SPECIES_256;
    private static final VectorSpecies<Double> DOUBLES_4 = DoubleVector.SPECIES_256;

    /**
     * How far a box's planes are moved outwards, as a fraction of the coordinates' size: four roundings of single
     * precision, of the inverse direction, of the origin's product with it, of the fused product and sum, and one to
     * spare.
     */
    private static final double MARGIN = 0x1p-22;

    /** Smaller components of a direction are replaced by this: within the margin until the ray has left the tree. */
    private static final double SMALLEST = 0x1p-60;

    /** Directions whose largest component is smaller than this, or larger than its inverse, are left to the kd-tree. */
    private static final double SHORTEST = 0x1p-20;

    private final int[] pool;
    private final double reach;
    private final StackTraversal exact;
    private final int[] entries = new int[BvhNode.WIDTH];
    private final double[] parameters = new double[BvhNode.TRIANGLES];
    private final double[] edgeProducts = new double[BvhNode.TRIANGLES];
    private final long[] outside = new long[BvhNode.TRIANGLES];

    /** Entry parameter as the bits of a float above, reference below: ordered as their parameters are. */
    private final long[] stack;

    // The ray in the form of the triangle test, and the best hit so far.
    private int offsetX;
    private int offsetY;
    private int offsetZ;
    private double originX;
    private double originY;
    private double originZ;
    private double shearX;
    private double shearY;
    private double shearZ;
    private double first;
    private double nearest;
    private int winner;
    private int winnerIndex;
    private int winnerBlock;

    /**
     * The block with the triangle that blocked the segment of the most recent query for any hit; none if nothing did.
     */
    private int obstacle = BvhNode.NONE;

    BvhTraversal(KDTree tree, Bvh wide) {
        super(tree.triangles());
        this.pool = wide.pool();
        this.reach = wide.reach();
        this.exact = new StackTraversal(tree);
        this.stack = new long[(BvhNode.WIDTH - 1) * wide.depth() + 1];
    }

    @Override
    protected void trace(double tMin, double tMax, boolean anyHit) {
        double size = Math.max(Math.abs(direction[0]), Math.max(Math.abs(direction[1]), Math.abs(direction[2])));
        double away = Math.max(Math.abs(origin[0]), Math.max(Math.abs(origin[1]), Math.abs(origin[2])));
        if (!(size > SHORTEST && size < 1.0 / SHORTEST && away < Bvh.FARTHEST)) {
            traceExactly(tMin, tMax);
            return;
        }
        setTriangleRay();
        first = tMin;
        nearest = tMax;
        winner = -1;
        if (!anyHit || !isHiddenAsBefore()) {
            walk(tMin, tMax, anyHit);
        }
        if (anyHit) {
            obstacle = winner < 0 ? BvhNode.NONE : BvhNode.leaf(winnerBlock, 1);
        }
        if (winner >= 0) {
            setHit(winner, nearest);
        }
    }

    /** Neighbouring segments are often hidden by the same triangle. */
    private boolean isHiddenAsBefore() {
        if (obstacle != BvhNode.NONE) {
            testBlocks(obstacle, 0);
        }
        return winner >= 0;
    }

    /** Leaves the ray to the kd-tree. The nearest hit is also any hit. */
    private void traceExactly(double tMin, double tMax) {
        if (exact.closestHit(origin[0], origin[1], origin[2], direction[0], direction[1], direction[2], tMin, tMax)) {
            setHit(exact.triangle(), exact.distance());
            setBarycentrics(exact.u(), exact.v());
        }
    }

    /** Computed from the block, which is in the cache; the mesh's own corners are not. */
    @Override
    protected void findBarycentrics() {
        double az = corner(winnerIndex, 0, offsetZ) - originZ;
        double bz = corner(winnerIndex, 1, offsetZ) - originZ;
        double cz = corner(winnerIndex, 2, offsetZ) - originZ;
        double ax = corner(winnerIndex, 0, offsetX) - originX - shearX * az;
        double ay = corner(winnerIndex, 0, offsetY) - originY - shearY * az;
        double bx = corner(winnerIndex, 1, offsetX) - originX - shearX * bz;
        double by = corner(winnerIndex, 1, offsetY) - originY - shearY * bz;
        double cx = corner(winnerIndex, 2, offsetX) - originX - shearX * cz;
        double cy = corner(winnerIndex, 2, offsetY) - originY - shearY * cz;
        double a = cx * by - cy * bx;
        double b = ax * cy - ay * cx;
        double g = bx * ay - by * ax;
        double determinant = a + b + g;
        setBarycentrics(b / determinant, g / determinant);
    }

    private float corner(int index, int corner, int offset) {
        return Float.intBitsToFloat(pool[index + corner * BvhNode.CORNER + offset]);
    }

    private void setTriangleRay() {
        double x = Math.abs(direction[0]);
        double y = Math.abs(direction[1]);
        double z = Math.abs(direction[2]);
        int kz = x > y ? (x > z ? 0 : 2) : (y > z ? 1 : 2);
        int kx = kz == 2 ? 0 : kz + 1;
        int ky = kx == 2 ? 0 : kx + 1;
        originX = origin[kx];
        originY = origin[ky];
        originZ = origin[kz];
        shearX = direction[kx] / direction[kz];
        shearY = direction[ky] / direction[kz];
        shearZ = inverse[kz];
        offsetX = BvhNode.coordinates(kx);
        offsetY = BvhNode.coordinates(ky);
        offsetZ = BvhNode.coordinates(kz);
    }

    private double bounded(int axis) {
        return Math.abs(direction[axis]) < SMALLEST ? Math.copySign(1.0 / SMALLEST, direction[axis]) : inverse[axis];
    }

    private static float roundedUp(double value) {
        float rounded = (float) value;
        return rounded < value ? Math.nextUp(rounded) : rounded;
    }

    private void walk(double tMin, double tMax, boolean anyHit) {
        int[] nodes = pool;
        long[] waiting = stack;
        int[] keys = entries;

        // A plane's parameter is plane * inverse + shift; the margins are folded into the shifts, separately for both
        // sides.
        double ix = bounded(0);
        double iy = bounded(1);
        double iz = bounded(2);
        double mx = MARGIN * (reach + Math.abs(origin[0])) * Math.abs(ix);
        double my = MARGIN * (reach + Math.abs(origin[1])) * Math.abs(iy);
        double mz = MARGIN * (reach + Math.abs(origin[2])) * Math.abs(iz);
        FloatVector inverseX = FloatVector.broadcast(FLOATS_8, (float) ix);
        FloatVector inverseY = FloatVector.broadcast(FLOATS_8, (float) iy);
        FloatVector inverseZ = FloatVector.broadcast(FLOATS_8, (float) iz);
        FloatVector entryX = FloatVector.broadcast(FLOATS_8, (float) (-origin[0] * ix - mx));
        FloatVector entryY = FloatVector.broadcast(FLOATS_8, (float) (-origin[1] * iy - my));
        FloatVector entryZ = FloatVector.broadcast(FLOATS_8, (float) (-origin[2] * iz - mz));
        FloatVector exitX = FloatVector.broadcast(FLOATS_8, (float) (-origin[0] * ix + mx));
        FloatVector exitY = FloatVector.broadcast(FLOATS_8, (float) (-origin[1] * iy + my));
        FloatVector exitZ = FloatVector.broadcast(FLOATS_8, (float) (-origin[2] * iz + mz));
        int nearX = ix < 0.0 ? BvhNode.upper(0) : BvhNode.lower(0);
        int nearY = iy < 0.0 ? BvhNode.upper(1) : BvhNode.lower(1);
        int nearZ = iz < 0.0 ? BvhNode.upper(2) : BvhNode.lower(2);
        int farX = ix < 0.0 ? BvhNode.lower(0) : BvhNode.upper(0);
        int farY = iy < 0.0 ? BvhNode.lower(1) : BvhNode.upper(1);
        int farZ = iz < 0.0 ? BvhNode.lower(2) : BvhNode.upper(2);

        // Parameters are compared as the bits of floats: those of positive floats are ordered as the floats are.
        IntVector start =
                IntVector.broadcast(INTS_8, Float.floatToRawIntBits(Math.max(0.0f, Math.nextDown((float) tMin))));
        int limit = Float.floatToRawIntBits(roundedUp(tMax));
        int stacked = 0;
        int reference = BvhNode.ROOT;
        while (true) {
            if (!BvhNode.isLeaf(reference)) {
                // Where each child's box is entered and left. A negative parameter has a negative pattern of bits: it
                // is behind the start, and more than that need not be known.
                IntVector ax = IntVector.fromArray(INTS_8, nodes, reference + nearX)
                        .reinterpretAsFloats()
                        .fma(inverseX, entryX)
                        .reinterpretAsInts();
                IntVector ay = IntVector.fromArray(INTS_8, nodes, reference + nearY)
                        .reinterpretAsFloats()
                        .fma(inverseY, entryY)
                        .reinterpretAsInts();
                IntVector az = IntVector.fromArray(INTS_8, nodes, reference + nearZ)
                        .reinterpretAsFloats()
                        .fma(inverseZ, entryZ)
                        .reinterpretAsInts();
                IntVector bx = IntVector.fromArray(INTS_8, nodes, reference + farX)
                        .reinterpretAsFloats()
                        .fma(inverseX, exitX)
                        .reinterpretAsInts();
                IntVector by = IntVector.fromArray(INTS_8, nodes, reference + farY)
                        .reinterpretAsFloats()
                        .fma(inverseY, exitY)
                        .reinterpretAsInts();
                IntVector bz = IntVector.fromArray(INTS_8, nodes, reference + farZ)
                        .reinterpretAsFloats()
                        .fma(inverseZ, exitZ)
                        .reinterpretAsInts();
                IntVector entered = ax.max(ay).max(az.max(start));
                IntVector left = bx.min(by)
                        .min(bz.min(IntVector.broadcast(INTS_8, limit)))
                        .max(IntVector.broadcast(INTS_8, -1));
                // A byte for each child, all ones where it is missed.
                long missed = ((ByteVector) left.sub(entered)
                                .lanewise(VectorOperators.ASHR, 31)
                                .convertShape(VectorOperators.I2B, ByteVector.SPECIES_64, 0))
                        .reinterpretShape(ByteVector.SPECIES_128, 0)
                        .reinterpretAsLongs()
                        .lane(0);
                long hits = ~missed;
                if (hits != 0) {
                    int node = reference;
                    int child = Long.numberOfTrailingZeros(hits) >>> 3;
                    hits &= ~(0xffL << (child << 3));
                    int only = BvhNode.reference(nodes, node, child);
                    if (hits == 0) {
                        reference = only;
                        continue;
                    }
                    if (anyHit) {
                        // Sorting costs more than it saves: most segments are free, and visit all.
                        reference = only;
                        do {
                            child = Long.numberOfTrailingZeros(hits) >>> 3;
                            hits &= ~(0xffL << (child << 3));
                            waiting[stacked++] = BvhNode.reference(nodes, node, child) & 0xffffffffL;
                        } while (hits != 0);
                        continue;
                    }
                    // The nearest child is next; the others wait, the nearest of them on top.
                    entered.intoArray(keys, 0);
                    long next = (long) keys[child] << 32 | only & 0xffffffffL;
                    int bottom = stacked;
                    do {
                        child = Long.numberOfTrailingZeros(hits) >>> 3;
                        hits &= ~(0xffL << (child << 3));
                        long found = (long) keys[child] << 32 | BvhNode.reference(nodes, node, child) & 0xffffffffL;
                        long farther = Math.max(next, found);
                        next = Math.min(next, found);
                        int slot = stacked++;
                        while (slot > bottom && waiting[slot - 1] < farther) {
                            waiting[slot] = waiting[slot - 1];
                            slot--;
                        }
                        waiting[slot] = farther;
                    } while (hits != 0);
                    reference = (int) next;
                    continue;
                }
            } else {
                limit = testBlocks(reference, limit);
                if (anyHit && winner >= 0) {
                    return;
                }
            }
            // What is entered beyond the nearest hit need not be visited.
            do {
                if (stacked == 0) {
                    return;
                }
                long top = waiting[--stacked];
                reference = (int) (top >>> 32) <= limit ? (int) top : BvhNode.NONE;
            } while (reference == BvhNode.NONE);
        }
    }

    /** Tests the triangles of a leaf; returns the limit for boxes, which is the nearest hit rounded up. */
    private int testBlocks(int leaf, int limitBefore) {
        int[] blocks = pool;
        double[] ts = parameters;
        double[] zeros = edgeProducts;
        long[] signs = outside;
        DoubleVector zero = DoubleVector.zero(DOUBLES_4);
        DoubleVector below = DoubleVector.broadcast(DOUBLES_4, Math.nextDown(first));
        DoubleVector ox = DoubleVector.broadcast(DOUBLES_4, originX);
        DoubleVector oy = DoubleVector.broadcast(DOUBLES_4, originY);
        DoubleVector oz = DoubleVector.broadcast(DOUBLES_4, originZ);
        DoubleVector sx = DoubleVector.broadcast(DOUBLES_4, shearX);
        DoubleVector sy = DoubleVector.broadcast(DOUBLES_4, shearY);
        DoubleVector sz = DoubleVector.broadcast(DOUBLES_4, shearZ);
        int x = offsetX;
        int y = offsetY;
        int z = offsetZ;
        int limit = limitBefore;
        int last = BvhNode.lastBlock(leaf);
        for (int block = BvhNode.firstBlock(leaf); block <= last; block += BvhNode.BLOCK) {
            // The corners relative to the sheared ray, as in TriangleIntersection, of four triangles.
            DoubleVector az = doubles(blocks, block + z).sub(oz);
            DoubleVector bz = doubles(blocks, block + BvhNode.CORNER + z).sub(oz);
            DoubleVector cz = doubles(blocks, block + 2 * BvhNode.CORNER + z).sub(oz);
            DoubleVector ax = doubles(blocks, block + x).sub(ox).sub(az.mul(sx));
            DoubleVector ay = doubles(blocks, block + y).sub(oy).sub(az.mul(sy));
            DoubleVector bx =
                    doubles(blocks, block + BvhNode.CORNER + x).sub(ox).sub(bz.mul(sx));
            DoubleVector by =
                    doubles(blocks, block + BvhNode.CORNER + y).sub(oy).sub(bz.mul(sy));
            DoubleVector cx =
                    doubles(blocks, block + 2 * BvhNode.CORNER + x).sub(ox).sub(cz.mul(sx));
            DoubleVector cy =
                    doubles(blocks, block + 2 * BvhNode.CORNER + y).sub(oy).sub(cz.mul(sy));

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
                    a.mul(az).add(b.mul(bz)).add(g.mul(cz)).div(a.add(b).add(g)).mul(sz);
            missed.or(t.sub(below).reinterpretAsLongs())
                    .or(DoubleVector.broadcast(DOUBLES_4, nearest + Double.MIN_VALUE)
                            .sub(t)
                            .reinterpretAsLongs())
                    .intoArray(signs, 0);
            int hits =
                    (int) (signs[0] >>> 63 | signs[1] >>> 63 << 1 | signs[2] >>> 63 << 2 | signs[3] >>> 63 << 3) ^ 15;
            if (hits == 0) {
                continue;
            }
            // Few get here. NaN, of triangles without area, fails both comparisons.
            t.intoArray(ts, 0);
            // Zero where an edge function is: only there can the ray be beside a triangle that it seems to hit.
            a.mul(b).mul(g).intoArray(zeros, 0);
            do {
                int lane = Integer.numberOfTrailingZeros(hits);
                hits &= hits - 1;
                double parameter = ts[lane];
                // Written out: the compiler inlines no more calls here, and around a call saves all vectors.
                int triangle = blocks[block + BvhNode.NUMBERS + lane];
                if (parameter >= first
                        && (parameter < nearest || parameter == nearest && (winner < 0 || triangle < winner))
                        && !(zeros[lane] == 0.0 && isBeside(block + lane))) {
                    nearest = parameter;
                    winner = triangle;
                    winnerIndex = block + lane;
                    winnerBlock = block;
                    limit = Float.floatToRawIntBits((float) parameter + 0.0f) + 1;
                }
            } while (hits != 0);
        }
        return limit;
    }

    /** Whether the ray passes beside a triangle seen edge-on. */
    private boolean isBeside(int index) {
        double az = corner(index, 0, offsetZ) - originZ;
        double bz = corner(index, 1, offsetZ) - originZ;
        double cz = corner(index, 2, offsetZ) - originZ;
        return isBeside(
                corner(index, 0, offsetX) - originX - shearX * az,
                corner(index, 0, offsetY) - originY - shearY * az,
                corner(index, 1, offsetX) - originX - shearX * bz,
                corner(index, 1, offsetY) - originY - shearY * bz,
                corner(index, 2, offsetX) - originX - shearX * cz,
                corner(index, 2, offsetY) - originY - shearY * cz);
    }

    private static DoubleVector doubles(int[] bits, int at) {
        return (DoubleVector) IntVector.fromArray(INTS_4, bits, at)
                .reinterpretAsFloats()
                .convertShape(VectorOperators.F2D, DOUBLES_4, 0);
    }
}
