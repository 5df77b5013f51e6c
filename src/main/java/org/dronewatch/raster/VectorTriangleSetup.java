package org.dronewatch.raster;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.VectorSpecies;
import org.dronewatch.kdtree.LeafOrderTriangles;

/**
 * Sets triangles up as {@link TriangleSetup} does, but four at a time, with vector instructions. Those without a
 * pixel's centre in the rectangle around them, up to half of them where triangles are small, are culled without a
 * branch. Each sum is added up in the same order as in {@link TriangleSetup}, so that the pixels are the same, bit for
 * bit. For the benefit, see {@link VectorRasteriser}.
 */
final class VectorTriangleSetup extends TriangleSetup {
    private static final VectorSpecies<Double> DOUBLES = DoubleVector.SPECIES_256;
    /** Triangles set up at once. */
    private static final int LANES = 4;

    // Methods are short, and loads and stores written out: the compiler's inlining is limited, and what it does
    // not inline moves vectors through the heap, which is slower than no vectors at all.

    // Offsets of the values of a triangle. Corners: in the world first, then in the tile's frame. Functions: three
    // values each, as lines take them.
    private static final int CORNER_A = 0;
    private static final int CORNER_B = 3 * LANES;
    private static final int CORNER_C = 6 * LANES;
    private static final int INVERSE = 9 * LANES;
    private static final int FIRST_EDGE = 12 * LANES;
    private static final int SECOND_EDGE = 15 * LANES;
    private static final int THIRD_EDGE = 18 * LANES;
    private static final int LEFT = 21 * LANES;
    private static final int RIGHT = 22 * LANES;
    private static final int UPPER = 23 * LANES;
    private static final int LOWER = 24 * LANES;
    /** Below zero when no pixel's centre lies in the rectangle. */
    private static final int EXTENT = 25 * LANES;
    /** Above zero when the functions are valid: the corners lie in front of the origin, which is not in their plane. */
    private static final int VALID = 26 * LANES;
    /** The sign of the edge functions, -1 or 1. */
    private static final int SIGN = 27 * LANES;

    private static final int VALUES = 28;

    /** Adding and subtracting it rounds to the nearest whole number. */
    private static final double WHOLE = 0x1.8p52;
    /** How far rectangles are widened before they are tested for pixels: more than lines look beside an edge. */
    private static final double SLACK = 3e-6;

    /** Four triangles side by side: their first values, their second values, and so on; then the next four. */
    private final double[] values = new double[VALUES * MOST];

    /** Which of the triangles may hold a pixel's centre. */
    private final int[] candidates = new int[MOST];

    // The origin, and the matrix from the world to the grid. Not in arrays, which the compiler would read again after
    // each
    // store into the values.
    private double originX;
    private double originY;
    private double originZ;
    private double depthOfX;
    private double depthOfY;
    private double depthOfZ;
    private double acrossOfX;
    private double acrossOfY;
    private double acrossOfZ;
    private double downwardsOfX;
    private double downwardsOfY;
    private double downwardsOfZ;

    VectorTriangleSetup(LeafOrderTriangles triangles, PixelGrid grid, TileBuffer pixels, VectorRasteriser lines) {
        super(triangles, grid, pixels, lines);
    }

    @Override
    void begin() {
        super.begin();
        originX = grid.origin[0];
        originY = grid.origin[1];
        originZ = grid.origin[2];
        double[] m = grid.toGrid;
        depthOfX = m[0];
        depthOfY = m[1];
        depthOfZ = m[2];
        acrossOfX = m[3];
        acrossOfY = m[4];
        acrossOfZ = m[5];
        downwardsOfX = m[6];
        downwardsOfY = m[7];
        downwardsOfZ = m[8];
    }

    @Override
    void rasterise(int[] indices, int count) {
        gather(indices, count);
        project(count);
        findPlanes(count);
        findEdges(count);
        int left = 0;
        for (int i = 0; i < count; i++) {
            candidates[left] = i;
            // NaN is kept: a corner lies beside the origin.
            left += values[valuesOf(i) + EXTENT] < 0.0 ? 0 : 1;
        }
        for (int i = 0; i < left; i++) {
            rasteriseGathered(candidates[i], indices[candidates[i]]);
        }
    }

    /** Gathers the corners of four triangles at a time, repeating the last one where there are fewer. */
    private void gather(int[] indices, int count) {
        int last = count - 1;
        for (int at = 0, i = 0; i < count; i += LANES, at += VALUES * LANES) {
            gather(indices[i], at);
            gather(indices[Math.min(i + 1, last)], at + 1);
            gather(indices[Math.min(i + 2, last)], at + 2);
            gather(indices[Math.min(i + 3, last)], at + 3);
        }
    }

    private void gather(int index, int at) {
        float[] c = corners;
        double[] n = values;
        int base = 9 * index;
        n[at] = c[base];
        n[at + LANES] = c[base + 1];
        n[at + 2 * LANES] = c[base + 2];
        n[at + CORNER_B] = c[base + 3];
        n[at + CORNER_B + LANES] = c[base + 4];
        n[at + CORNER_B + 2 * LANES] = c[base + 5];
        n[at + CORNER_C] = c[base + 6];
        n[at + CORNER_C + LANES] = c[base + 7];
        n[at + CORNER_C + 2 * LANES] = c[base + 8];
    }

    private void rasteriseGathered(int i, int index) {
        double[] n = values;
        int at = valuesOf(i);
        if (!(n[at + VALID] > 0.0)) {
            super.rasterise(index);
            return;
        }
        int fromColumn = ScanlineRasteriser.atOrAfter(n[at + LEFT]);
        int toColumn = ScanlineRasteriser.atOrBefore(n[at + RIGHT]);
        int fromRow = ScanlineRasteriser.atOrAfter(n[at + UPPER]);
        int toRow = ScanlineRasteriser.atOrBefore(n[at + LOWER]);
        if (fromColumn > toColumn || fromRow > toRow) {
            return;
        }
        lines.setRectangle(fromColumn, toColumn, fromRow, toRow);
        int f = at + INVERSE;
        lines.setInverse(n[f], n[f + LANES], n[f + 2 * LANES]);
        f = at + FIRST_EDGE;
        lines.setFirstEdge(n[f], n[f + LANES], n[f + 2 * LANES]);
        f = at + SECOND_EDGE;
        lines.setSecondEdge(n[f], n[f + LANES], n[f + 2 * LANES]);
        f = at + THIRD_EDGE;
        lines.setThirdEdge(n[f], n[f + LANES], n[f + 2 * LANES]);
        lines.rasterise(numbers[index]);
    }

    private static int valuesOf(int i) {
        return i / LANES * (VALUES * LANES) + i % LANES;
    }

    /** Transforms a corner into the tile's frame. */
    private void moveToTile(int at, int corner) {
        DoubleVector x = DoubleVector.fromArray(DOUBLES, values, at + corner).sub(originX);
        DoubleVector y =
                DoubleVector.fromArray(DOUBLES, values, at + corner + LANES).sub(originY);
        DoubleVector z =
                DoubleVector.fromArray(DOUBLES, values, at + corner + 2 * LANES).sub(originZ);
        DoubleVector depth = x.mul(depthOfX).add(y.mul(depthOfY)).add(z.mul(depthOfZ));
        DoubleVector across = x.mul(acrossOfX).add(y.mul(acrossOfY)).add(z.mul(acrossOfZ));
        DoubleVector downwards = x.mul(downwardsOfX).add(y.mul(downwardsOfY)).add(z.mul(downwardsOfZ));
        across.sub(depth.mul((double) pixels.left())).intoArray(values, at + corner);
        downwards.sub(depth.mul((double) pixels.top())).intoArray(values, at + corner + LANES);
        depth.intoArray(values, at + corner + 2 * LANES);
    }

    /** The corners in the tile's frame, and the rectangles around them. */
    private void project(int count) {
        DoubleVector one = DoubleVector.broadcast(DOUBLES, 1.0);
        for (int at = 0, i = 0; i < count; i += LANES, at += VALUES * LANES) {
            moveToTile(at, CORNER_A);
            moveToTile(at, CORNER_B);
            moveToTile(at, CORNER_C);
            DoubleVector az = DoubleVector.fromArray(DOUBLES, values, at + CORNER_A + 2 * LANES);
            DoubleVector bz = DoubleVector.fromArray(DOUBLES, values, at + CORNER_B + 2 * LANES);
            DoubleVector cz = DoubleVector.fromArray(DOUBLES, values, at + CORNER_C + 2 * LANES);
            DoubleVector ofA = one.div(az);
            DoubleVector ofB = one.div(bz);
            DoubleVector ofC = one.div(cz);
            DoubleVector ofAx =
                    DoubleVector.fromArray(DOUBLES, values, at + CORNER_A).mul(ofA);
            DoubleVector ofBx =
                    DoubleVector.fromArray(DOUBLES, values, at + CORNER_B).mul(ofB);
            DoubleVector ofCx =
                    DoubleVector.fromArray(DOUBLES, values, at + CORNER_C).mul(ofC);
            DoubleVector ofAy = DoubleVector.fromArray(DOUBLES, values, at + CORNER_A + LANES)
                    .mul(ofA);
            DoubleVector ofBy = DoubleVector.fromArray(DOUBLES, values, at + CORNER_B + LANES)
                    .mul(ofB);
            DoubleVector ofCy = DoubleVector.fromArray(DOUBLES, values, at + CORNER_C + LANES)
                    .mul(ofC);
            DoubleVector low = ofAx.min(ofBx.min(ofCx)).max(0.0);
            DoubleVector high = ofAx.max(ofBx.max(ofCx)).min(pixels.lastColumn());
            DoubleVector upper = ofAy.min(ofBy.min(ofCy)).max(0.0);
            DoubleVector lower = ofAy.max(ofBy.max(ofCy)).min(pixels.lastRow());
            low.intoArray(values, at + LEFT);
            high.intoArray(values, at + RIGHT);
            upper.intoArray(values, at + UPPER);
            lower.intoArray(values, at + LOWER);
            DoubleVector columns =
                    high.add(SLACK).sub(low.add(0.5 - SLACK).add(WHOLE).sub(WHOLE));
            DoubleVector rows =
                    lower.add(SLACK).sub(upper.add(0.5 - SLACK).add(WHOLE).sub(WHOLE));
            // The rectangle is meaningless when a corner does not lie in front of the origin: the triangle is kept
            // then.
            DoubleVector before = az.min(bz.min(cz)).sub(Double.MIN_NORMAL);
            columns.min(rows).max(before.neg()).intoArray(values, at + EXTENT);
            before.intoArray(values, at + VALID);
        }
    }

    /** The triangles' planes, and the inverse ray parameter on them. */
    private void findPlanes(int count) {
        DoubleVector one = DoubleVector.broadcast(DOUBLES, 1.0);
        for (int at = 0, i = 0; i < count; i += LANES, at += VALUES * LANES) {
            DoubleVector ax = DoubleVector.fromArray(DOUBLES, values, at + CORNER_A);
            DoubleVector ay = DoubleVector.fromArray(DOUBLES, values, at + CORNER_A + LANES);
            DoubleVector az = DoubleVector.fromArray(DOUBLES, values, at + CORNER_A + 2 * LANES);
            DoubleVector toBx =
                    DoubleVector.fromArray(DOUBLES, values, at + CORNER_B).sub(ax);
            DoubleVector toBy = DoubleVector.fromArray(DOUBLES, values, at + CORNER_B + LANES)
                    .sub(ay);
            DoubleVector toBz = DoubleVector.fromArray(DOUBLES, values, at + CORNER_B + 2 * LANES)
                    .sub(az);
            DoubleVector toCx =
                    DoubleVector.fromArray(DOUBLES, values, at + CORNER_C).sub(ax);
            DoubleVector toCy = DoubleVector.fromArray(DOUBLES, values, at + CORNER_C + LANES)
                    .sub(ay);
            DoubleVector toCz = DoubleVector.fromArray(DOUBLES, values, at + CORNER_C + 2 * LANES)
                    .sub(az);
            DoubleVector nx = toBy.mul(toCz).sub(toBz.mul(toCy));
            DoubleVector ny = toBz.mul(toCx).sub(toBx.mul(toCz));
            DoubleVector nz = toBx.mul(toCy).sub(toBy.mul(toCx));
            DoubleVector partX = ax.mul(nx);
            DoubleVector partY = ay.mul(ny);
            DoubleVector partZ = az.mul(nz);
            DoubleVector volume = partX.add(partY).add(partZ);
            DoubleVector parts = partX.abs().add(partY.abs()).add(partZ.abs());
            volume.abs()
                    .sub(parts.mul(IN_PLANE))
                    .min(DoubleVector.fromArray(DOUBLES, values, at + VALID))
                    .intoArray(values, at + VALID);
            DoubleVector inverse = one.div(volume);
            nz.mul(inverse).intoArray(values, at + INVERSE);
            nx.mul(inverse).intoArray(values, at + INVERSE + LANES);
            ny.mul(inverse).intoArray(values, at + INVERSE + 2 * LANES);
            // 1 with the volume's sign.
            volume.reinterpretAsLongs()
                    .and(Long.MIN_VALUE)
                    .or(one.reinterpretAsLongs())
                    .reinterpretAsDoubles()
                    .intoArray(values, at + SIGN);
        }
    }

    /** The edge functions, with the sign that makes inside positive for what lies in front of the origin. */
    private void findEdges(int count) {
        for (int at = 0, i = 0; i < count; i += LANES, at += VALUES * LANES) {
            DoubleVector ax = DoubleVector.fromArray(DOUBLES, values, at + CORNER_A);
            DoubleVector ay = DoubleVector.fromArray(DOUBLES, values, at + CORNER_A + LANES);
            DoubleVector az = DoubleVector.fromArray(DOUBLES, values, at + CORNER_A + 2 * LANES);
            DoubleVector bx = DoubleVector.fromArray(DOUBLES, values, at + CORNER_B);
            DoubleVector by = DoubleVector.fromArray(DOUBLES, values, at + CORNER_B + LANES);
            DoubleVector bz = DoubleVector.fromArray(DOUBLES, values, at + CORNER_B + 2 * LANES);
            DoubleVector cx = DoubleVector.fromArray(DOUBLES, values, at + CORNER_C);
            DoubleVector cy = DoubleVector.fromArray(DOUBLES, values, at + CORNER_C + LANES);
            DoubleVector cz = DoubleVector.fromArray(DOUBLES, values, at + CORNER_C + 2 * LANES);
            DoubleVector sign = DoubleVector.fromArray(DOUBLES, values, at + SIGN);
            bx.mul(cy).sub(by.mul(cx)).mul(sign).intoArray(values, at + FIRST_EDGE);
            by.mul(cz).sub(bz.mul(cy)).mul(sign).intoArray(values, at + FIRST_EDGE + LANES);
            bz.mul(cx).sub(bx.mul(cz)).mul(sign).intoArray(values, at + FIRST_EDGE + 2 * LANES);
            cx.mul(ay).sub(cy.mul(ax)).mul(sign).intoArray(values, at + SECOND_EDGE);
            cy.mul(az).sub(cz.mul(ay)).mul(sign).intoArray(values, at + SECOND_EDGE + LANES);
            cz.mul(ax).sub(cx.mul(az)).mul(sign).intoArray(values, at + SECOND_EDGE + 2 * LANES);
            ax.mul(by).sub(ay.mul(bx)).mul(sign).intoArray(values, at + THIRD_EDGE);
            ay.mul(bz).sub(az.mul(by)).mul(sign).intoArray(values, at + THIRD_EDGE + LANES);
            az.mul(bx).sub(ax.mul(bz)).mul(sign).intoArray(values, at + THIRD_EDGE + 2 * LANES);
        }
    }
}
