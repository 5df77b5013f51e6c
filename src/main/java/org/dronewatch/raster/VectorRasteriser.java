package org.dronewatch.raster;

import jdk.incubator.vector.DoubleVector;
import jdk.incubator.vector.LongVector;
import jdk.incubator.vector.VectorOperators;
import jdk.incubator.vector.VectorSpecies;

/**
 * Rasterises triangles of few columns four pixels at a time, with vector instructions; others as
 * {@link ScanlineRasteriser} does. All pixels of a triangle's rectangle are tested, without a branch for any of them:
 * where triangles are small, most of these pixels are inside.
 *
 * <p>The benefit: with {@link VectorTriangleSetup}, images of two million triangles are drawn 1.5 to 2 times as fast
 * once the just-in-time compiler has compiled this code ({@code PictureTracing}). Each sum is added up in the same
 * order as in {@link ScanlineRasteriser}, so that the pixels are the same, bit for bit.
 */
final class VectorRasteriser extends ScanlineRasteriser {
    private static final VectorSpecies<Double> DOUBLES = DoubleVector.SPECIES_256;
    private static final int LANES = TileBuffer.LANES;
    /** Triangles that may have more columns are rasterised by lines. */
    private static final int MAX_COLUMNS = 24;

    VectorRasteriser(TileBuffer pixels) {
        super(pixels);
    }

    @Override
    void rasterise(int triangle) {
        if (toColumn - fromColumn >= MAX_COLUMNS) {
            super.rasterise(triangle);
            return;
        }
        double[] nearest = pixels.nearest;
        double[] seen = pixels.triangles;
        int width = pixels.width();
        // Each sum in the order of lines: first the value at the corner and the line's part, then the pixel's. What is
        // added to the other part turns -0 into +0: so no sum is -0, and its sign separates inside from outside.
        boolean upright = isUpright();
        double rToRows = upright ? 0.0 : r;
        double eToRows = upright ? 0.0 : e;
        double fToRows = upright ? 0.0 : f;
        double gToRows = upright ? 0.0 : g;
        double rToColumns = upright ? r : 0.0;
        double eToColumns = upright ? e : 0.0;
        double fToColumns = upright ? f : 0.0;
        double gToColumns = upright ? g : 0.0;
        DoubleVector number = DoubleVector.broadcast(DOUBLES, triangle);
        for (int left = fromColumn; left <= toColumn; left += LANES) {
            DoubleVector columns = DoubleVector.fromArray(DOUBLES, pixels.columnNumbers, left);
            // Vectors reach beyond the rectangle, even beyond the row. The functions of a triangle that is seen
            // edge-on may be noise above zero there.
            LongVector beside = columns.neg().add(toColumn).reinterpretAsLongs();
            DoubleVector rOfColumns = columns.mul(rOfColumn).add(rToColumns);
            DoubleVector eOfColumns = columns.mul(eOfColumn).add(eToColumns);
            DoubleVector fOfColumns = columns.mul(fOfColumn).add(fToColumns);
            DoubleVector gOfColumns = columns.mul(gOfColumn).add(gToColumns);
            for (int row = fromRow; row <= toRow; row++) {
                int at = row * width + left;
                LongVector outside = eOfColumns
                        .add(eToRows + row * eOfRow)
                        .reinterpretAsLongs()
                        .or(fOfColumns.add(fToRows + row * fOfRow).reinterpretAsLongs())
                        .or(gOfColumns.add(gToRows + row * gOfRow).reinterpretAsLongs())
                        .or(beside)
                        .and(Long.MIN_VALUE);
                // Outside it gets a minus, and is not above what the pixel sees.
                DoubleVector here = rOfColumns
                        .add(rToRows + row * rOfRow)
                        .reinterpretAsLongs()
                        .or(outside)
                        .reinterpretAsDoubles();
                DoubleVector before = DoubleVector.fromArray(DOUBLES, nearest, at);
                var nearer = here.compare(VectorOperators.GT, before);
                before.blend(here, nearer).intoArray(nearest, at);
                DoubleVector.fromArray(DOUBLES, seen, at).blend(number, nearer).intoArray(seen, at);
            }
        }
    }
}
