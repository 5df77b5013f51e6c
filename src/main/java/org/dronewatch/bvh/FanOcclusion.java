package org.dronewatch.bvh;

import jdk.incubator.vector.FloatVector;
import jdk.incubator.vector.IntVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Tests which segments of a {@link FanBeam} are hidden by triangles. Since the segments have a common origin, the edge
 * functions of a triangle, and its distance, are linear in the direction of a segment: their coefficients are therefore
 * computed once, for eight triangles at a time, relative to the middle of the beam. Triangles that are beside the beam
 * or behind it are left out; for the others, the functions are evaluated for eight segments at a time.
 *
 * <p>All of this is in single precision, with bounded errors. A segment is therefore either certainly hidden by a
 * triangle, or certainly not hidden, or in doubt. For use by one thread.
 */
final class FanOcclusion {
    /** How many triangles are tested at a time. */
    static final int TRIANGLES = 8;

    private static final VectorSpecies<Float> FLOATS = FloatVector.SPECIES_256;
    private static final VectorSpecies<Integer> INTS = IntVector.SPECIES_256;

    /** Four times the largest rounding error in single precision, and above it in double precision, relative. */
    private static final float ROUNDING = 0x1p-22f;

    private static final float EXACT_ROUNDING = 0x1p-44f;

    /** A lower bound on the fraction of a segment's length that lies along its longest axis. */
    private static final float LEAST_AHEAD = 0.57f;

    private static final long SIGNS = 0x8000000080000000L;

    private final float[] corners;
    private final FanBeam beam;

    // The origin in the axes of the beam.
    private double originAcross;
    private double originAlong;
    private double originAhead;

    /** Length at both ends of a segment within which triangles do not count, m. */
    private float skipped;

    private final int[] triangles = new int[TRIANGLES];
    private int count;

    /** Coordinates of the triangles: eight numbers for each coordinate of each corner. */
    private final float[] shapes = new float[9 * TRIANGLES];

    /**
     * Coefficients of their functions: eight numbers for each. Three edge functions and their sum: value in the middle,
     * slope across and slope along.
     */
    private final float[] functions = new float[12 * TRIANGLES];

    /** Six times the volumes of the tetrahedra of the origin and the triangles, with a sign. */
    private final float[] volumes = new float[TRIANGLES];

    private final float[] edgeErrors = new float[TRIANGLES];
    private final float[] volumeErrors = new float[TRIANGLES];

    /** The error of all functions. */
    private final float[] errors = new float[TRIANGLES];

    /** Error less what the sum times the end has to exceed. */
    private final float[] constants = new float[TRIANGLES];

    /** Negative if a triangle lies behind where the segments begin. */
    private final int[] behindStart = new int[TRIANGLES];

    /** Negative if a triangle lies beside the beam, or before the segments begin: it hides nothing. */
    private final int[] beside = new int[TRIANGLES];

    /** Negative if it hides nothing, provided that it is known which side of it is seen. */
    private final int[] missed = new int[TRIANGLES];

    FanOcclusion(float[] corners, FanBeam beam) {
        this.corners = corners;
        this.beam = beam;
    }

    /** Begins a beam from an origin. */
    void begin(double[] origin, double skippedLength) {
        skipped = (float) skippedLength;
        originAcross = origin[beam.axisAcross];
        originAlong = origin[beam.axisAlong];
        originAhead = origin[beam.axisAhead];
        count = 0;
    }

    /**
     * Adds a triangle, given by its index in leaf order, to those that are tested.
     *
     * @return whether they are as many as can be tested at a time
     */
    boolean add(int triangle) {
        float[] c = corners;
        int base = 9 * triangle;
        int x = base + beam.axisAcross;
        int y = base + beam.axisAlong;
        int z = base + beam.axisAhead;

        // The corners relative to the origin, sheared so that the middle of the beam becomes the axis ahead.
        double az = beam.sign * (c[z] - originAhead);
        double bz = beam.sign * (c[z + 3] - originAhead);
        double cz = beam.sign * (c[z + 6] - originAhead);
        double u = beam.middleAcross;
        double v = beam.middleAlong;
        float[] s = shapes;
        int i = count;
        s[i] = (float) (c[x] - originAcross - u * az);
        s[i + TRIANGLES] = (float) (c[y] - originAlong - v * az);
        s[i + 2 * TRIANGLES] = (float) az;
        s[i + 3 * TRIANGLES] = (float) (c[x + 3] - originAcross - u * bz);
        s[i + 4 * TRIANGLES] = (float) (c[y + 3] - originAlong - v * bz);
        s[i + 5 * TRIANGLES] = (float) bz;
        s[i + 6 * TRIANGLES] = (float) (c[x + 6] - originAcross - u * cz);
        s[i + 7 * TRIANGLES] = (float) (c[y + 6] - originAlong - v * cz);
        s[i + 8 * TRIANGLES] = (float) cz;
        triangles[i] = triangle;
        count++;
        return count == TRIANGLES;
    }

    /**
     * Tests the triangles that were added.
     *
     * @return the index of the triangle after which all segments of the beam are hidden; -1 if they are not
     */
    int test() {
        int added = count;
        count = 0;
        if (added == 0) {
            return -1;
        }
        if (findBeside()) {
            return -1;
        }
        findFunctions();
        boundErrors();
        findMissed();
        findBeyond();
        for (int i = 0; i < added; i++) {
            boolean isEdgeOn = Math.abs(volumes[i]) <= volumeErrors[i];
            if (beside[i] >= 0 && (missed[i] >= 0 || isEdgeOn)) {
                float sign = volumes[i] < 0.0f ? -1.0f : 1.0f;
                float certain = behindStart[i] < 0 && !isEdgeOn ? 3.0f * errors[i] : Float.POSITIVE_INFINITY;
                boolean isRestHidden = evaluate(i, sign, certain);
                if (isEdgeOn) {
                    // Or seen from a point in its plane: it is not known which side is seen.
                    isRestHidden |= evaluate(i, -sign, certain);
                }
                if (isRestHidden) {
                    return triangles[i];
                }
            }
        }
        return -1;
    }

    // In four parts, which pass vectors on in arrays: the compiler does not inline enough for one.

    /**
     * Finds out which triangles are beside the beam: all corners are beyond one of its sides; returns whether all are.
     */
    private boolean findBeside() {
        FloatVector halfX = FloatVector.broadcast(FLOATS, (float) beam.halfAcross);
        FloatVector halfY = FloatVector.broadcast(FLOATS, (float) beam.halfAlong);
        FloatVector ax = FloatVector.fromArray(FLOATS, shapes, 0);
        FloatVector bx = FloatVector.fromArray(FLOATS, shapes, 3 * TRIANGLES);
        FloatVector cx = FloatVector.fromArray(FLOATS, shapes, 6 * TRIANGLES);
        FloatVector az = FloatVector.fromArray(FLOATS, shapes, 2 * TRIANGLES);
        FloatVector bz = FloatVector.fromArray(FLOATS, shapes, 5 * TRIANGLES);
        FloatVector cz = FloatVector.fromArray(FLOATS, shapes, 8 * TRIANGLES);
        FloatVector aside = az.mul(halfX);
        FloatVector bside = bz.mul(halfX);
        FloatVector cside = cz.mul(halfX);
        IntVector left = ax.add(aside)
                .reinterpretAsInts()
                .and(bx.add(bside).reinterpretAsInts())
                .and(cx.add(cside).reinterpretAsInts());
        IntVector right = aside.sub(ax)
                .reinterpretAsInts()
                .and(bside.sub(bx).reinterpretAsInts())
                .and(cside.sub(cx).reinterpretAsInts());
        FloatVector ay = FloatVector.fromArray(FLOATS, shapes, TRIANGLES);
        FloatVector by = FloatVector.fromArray(FLOATS, shapes, 4 * TRIANGLES);
        FloatVector cy = FloatVector.fromArray(FLOATS, shapes, 7 * TRIANGLES);
        aside = az.mul(halfY);
        bside = bz.mul(halfY);
        cside = cz.mul(halfY);
        IntVector below = ay.add(aside)
                .reinterpretAsInts()
                .and(by.add(bside).reinterpretAsInts())
                .and(cy.add(cside).reinterpretAsInts());
        IntVector above = aside.sub(ay)
                .reinterpretAsInts()
                .and(bside.sub(by).reinterpretAsInts())
                .and(cside.sub(cy).reinterpretAsInts());
        IntVector outside = left.or(right).or(below).or(above);
        outside.intoArray(beside, 0);
        return areAllNegative(outside);
    }

    /** Computes the edge functions, whose sign inside the triangle is that of the volume, and their sum. */
    private void findFunctions() {
        FloatVector ax = FloatVector.fromArray(FLOATS, shapes, 0);
        FloatVector ay = FloatVector.fromArray(FLOATS, shapes, TRIANGLES);
        FloatVector az = FloatVector.fromArray(FLOATS, shapes, 2 * TRIANGLES);
        FloatVector bx = FloatVector.fromArray(FLOATS, shapes, 3 * TRIANGLES);
        FloatVector by = FloatVector.fromArray(FLOATS, shapes, 4 * TRIANGLES);
        FloatVector bz = FloatVector.fromArray(FLOATS, shapes, 5 * TRIANGLES);
        FloatVector cx = FloatVector.fromArray(FLOATS, shapes, 6 * TRIANGLES);
        FloatVector cy = FloatVector.fromArray(FLOATS, shapes, 7 * TRIANGLES);
        FloatVector cz = FloatVector.fromArray(FLOATS, shapes, 8 * TRIANGLES);
        FloatVector p1 = bx.mul(cy).sub(by.mul(cx));
        FloatVector q1 = by.mul(cz).sub(bz.mul(cy));
        FloatVector r1 = bz.mul(cx).sub(bx.mul(cz));
        ax.mul(q1).add(ay.mul(r1)).add(az.mul(p1)).intoArray(volumes, 0);
        FloatVector p2 = cx.mul(ay).sub(cy.mul(ax));
        FloatVector q2 = cy.mul(az).sub(cz.mul(ay));
        FloatVector r2 = cz.mul(ax).sub(cx.mul(az));
        FloatVector p3 = ax.mul(by).sub(ay.mul(bx));
        FloatVector q3 = ay.mul(bz).sub(az.mul(by));
        FloatVector r3 = az.mul(bx).sub(ax.mul(bz));
        p1.intoArray(functions, 0);
        q1.intoArray(functions, TRIANGLES);
        r1.intoArray(functions, 2 * TRIANGLES);
        p2.intoArray(functions, 3 * TRIANGLES);
        q2.intoArray(functions, 4 * TRIANGLES);
        r2.intoArray(functions, 5 * TRIANGLES);
        p3.intoArray(functions, 6 * TRIANGLES);
        q3.intoArray(functions, 7 * TRIANGLES);
        r3.intoArray(functions, 8 * TRIANGLES);
        p1.add(p2).add(p3).intoArray(functions, 9 * TRIANGLES);
        q1.add(q2).add(q3).intoArray(functions, 10 * TRIANGLES);
        r1.add(r2).add(r3).intoArray(functions, 11 * TRIANGLES);
    }

    /** Bounds the errors, from the largest offset of a corner to the side, and the largest one ahead. */
    private void boundErrors() {
        IntVector a = offset(0);
        IntVector b = offset(3 * TRIANGLES);
        IntVector c = offset(6 * TRIANGLES);
        FloatVector side = a.max(b).max(c).reinterpretAsFloats();
        IntVector az =
                FloatVector.fromArray(FLOATS, shapes, 2 * TRIANGLES).abs().reinterpretAsInts();
        IntVector bz =
                FloatVector.fromArray(FLOATS, shapes, 5 * TRIANGLES).abs().reinterpretAsInts();
        IntVector cz =
                FloatVector.fromArray(FLOATS, shapes, 8 * TRIANGLES).abs().reinterpretAsInts();
        FloatVector ahead = az.max(bz).max(cz).reinterpretAsFloats();
        FloatVector all = side.add(ahead).add(ahead);
        FloatVector exact = all.mul(all).mul(EXACT_ROUNDING);
        FloatVector half = FloatVector.broadcast(FLOATS, (float) (8.0 * (beam.halfAcross + beam.halfAlong) + 2.0));
        side.mul(side.mul(4.0f).add(ahead.mul(half)))
                .mul(ROUNDING)
                .add(exact)
                .add(Float.MIN_NORMAL)
                .intoArray(edgeErrors, 0);
        side.mul(side)
                .mul(ahead)
                .mul(8.0f * ROUNDING)
                .add(all.mul(exact))
                .add(Float.MIN_NORMAL)
                .intoArray(volumeErrors, 0);
    }

    private IntVector offset(int corner) {
        // Positive numbers are ordered as their bits are.
        return FloatVector.fromArray(FLOATS, shapes, corner)
                .abs()
                .add(FloatVector.fromArray(FLOATS, shapes, corner + TRIANGLES).abs())
                .reinterpretAsInts();
    }

    /** Finds out which triangles the beam misses. */
    private void findMissed() {
        highest(0).or(highest(3 * TRIANGLES)).or(highest(6 * TRIANGLES)).intoArray(missed, 0);
    }

    /** The highest value of an edge function in the beam, with the sign that is positive inside; as bits. */
    private IntVector highest(int function) {
        IntVector sign = FloatVector.fromArray(FLOATS, volumes, 0)
                .reinterpretAsInts()
                .and(IntVector.broadcast(INTS, Integer.MIN_VALUE));
        return FloatVector.fromArray(FLOATS, functions, function)
                .reinterpretAsInts()
                .lanewise(VectorOperators.XOR, sign)
                .reinterpretAsFloats()
                .add(FloatVector.fromArray(FLOATS, functions, function + TRIANGLES)
                        .abs()
                        .mul((float) beam.halfAcross))
                .add(FloatVector.fromArray(FLOATS, functions, function + 2 * TRIANGLES)
                        .abs()
                        .mul((float) beam.halfAlong))
                .add(FloatVector.fromArray(FLOATS, edgeErrors, 0))
                .reinterpretAsInts();
    }

    /** Finds out which triangles lie beyond the ends of all segments, and which lie before their beginnings. */
    private void findBeyond() {
        FloatVector signed = FloatVector.fromArray(FLOATS, volumes, 0);
        FloatVector volume = signed.abs();
        IntVector sign = signed.reinterpretAsInts().and(IntVector.broadcast(INTS, Integer.MIN_VALUE));
        FloatVector volumeError = FloatVector.fromArray(FLOATS, volumeErrors, 0);
        FloatVector edgeError = FloatVector.fromArray(FLOATS, edgeErrors, 0);
        FloatVector sumError = edgeError.mul(3.0f);
        FloatVector middle = FloatVector.fromArray(FLOATS, functions, 9 * TRIANGLES)
                .reinterpretAsInts()
                .lanewise(VectorOperators.XOR, sign)
                .reinterpretAsFloats();
        FloatVector change = FloatVector.fromArray(FLOATS, functions, 10 * TRIANGLES)
                .abs()
                .mul((float) beam.halfAcross)
                .add(FloatVector.fromArray(FLOATS, functions, 11 * TRIANGLES)
                        .abs()
                        .mul((float) beam.halfAlong))
                .add(sumError);
        FloatVector most = middle.add(change);
        float perMetre = (float) (1.0 / beam.farthest);
        FloatVector depth = volume.mul(perMetre);
        FloatVector farError = most.abs()
                .mul(4.0f * ROUNDING + 2.0f * skipped * perMetre)
                .add(sumError)
                .add(volumeError.mul(2.0f * perMetre))
                .add(depth.mul(2.0f * ROUNDING));
        FloatVector error =
                edgeError.reinterpretAsInts().max(farError.reinterpretAsInts()).reinterpretAsFloats();
        IntVector.fromArray(INTS, missed, 0)
                .or(most.sub(depth).add(farError).reinterpretAsInts())
                .intoArray(missed, 0);
        IntVector.fromArray(INTS, beside, 0)
                .or(volume.add(volumeError)
                        .sub(middle.abs().sub(change).mul(LEAST_AHEAD * skipped))
                        .reinterpretAsInts())
                .intoArray(beside, 0);
        most.mul(1.01f * skipped)
                .add(volumeError)
                .sub(volume)
                .reinterpretAsInts()
                .intoArray(behindStart, 0);
        error.intoArray(errors, 0);
        error.sub(depth).intoArray(constants, 0);
    }

    /** Finds out which segments a triangle hides; returns whether all segments of the beam are hidden after that. */
    private boolean evaluate(int triangle, float sign, float certain) {
        float[] f = functions;
        float error = errors[triangle];
        FloatVector a0 = FloatVector.broadcast(FLOATS, sign * f[triangle] + error);
        FloatVector a1 = FloatVector.broadcast(FLOATS, sign * f[triangle + TRIANGLES]);
        FloatVector a2 = FloatVector.broadcast(FLOATS, sign * f[triangle + 2 * TRIANGLES]);
        FloatVector b0 = FloatVector.broadcast(FLOATS, sign * f[triangle + 3 * TRIANGLES] + error);
        FloatVector b1 = FloatVector.broadcast(FLOATS, sign * f[triangle + 4 * TRIANGLES]);
        FloatVector b2 = FloatVector.broadcast(FLOATS, sign * f[triangle + 5 * TRIANGLES]);
        FloatVector c0 = FloatVector.broadcast(FLOATS, sign * f[triangle + 6 * TRIANGLES] + error);
        FloatVector c1 = FloatVector.broadcast(FLOATS, sign * f[triangle + 7 * TRIANGLES]);
        FloatVector c2 = FloatVector.broadcast(FLOATS, sign * f[triangle + 8 * TRIANGLES]);
        FloatVector s0 = FloatVector.broadcast(FLOATS, sign * f[triangle + 9 * TRIANGLES]);
        FloatVector s1 = FloatVector.broadcast(FLOATS, sign * f[triangle + 10 * TRIANGLES]);
        FloatVector s2 = FloatVector.broadcast(FLOATS, sign * f[triangle + 11 * TRIANGLES]);
        FloatVector nearer = FloatVector.broadcast(FLOATS, constants[triangle]);
        FloatVector limit = FloatVector.broadcast(FLOATS, certain);
        float[] x = beam.across;
        float[] y = beam.along;
        float[] ends = beam.ends;
        int[] blocked = beam.blocked;
        int[] clear = beam.clear;
        IntVector all = IntVector.broadcast(INTS, -1);
        int to = beam.padded();
        for (int i = 0; i < to; i += FanBeam.WIDTH) {
            FloatVector u = FloatVector.fromArray(FLOATS, x, i);
            FloatVector v = FloatVector.fromArray(FLOATS, y, i);
            FloatVector sum = v.fma(s2, u.fma(s1, s0));
            // The least as bits: those of positive numbers are ordered as the numbers are, negative ones are lower.
            IntVector least = v.fma(a2, u.fma(a1, a0))
                    .reinterpretAsInts()
                    .min(v.fma(b2, u.fma(b1, b0)).reinterpretAsInts())
                    .min(v.fma(c2, u.fma(c1, c0)).reinterpretAsInts())
                    .min(sum.fma(FloatVector.fromArray(FLOATS, ends, i), nearer).reinterpretAsInts());
            IntVector hidden = IntVector.fromArray(INTS, blocked, i)
                    .or(limit.sub(least.reinterpretAsFloats()).reinterpretAsInts());
            hidden.intoArray(blocked, i);
            IntVector.fromArray(INTS, clear, i).and(least).intoArray(clear, i);
            all = all.and(hidden);
        }
        return areAllNegative(all);
    }

    private static boolean areAllNegative(IntVector numbers) {
        LongVector words = numbers.reinterpretAsLongs();
        return (words.lane(0) & words.lane(1) & words.lane(2) & words.lane(3) & SIGNS) == SIGNS;
    }
}
