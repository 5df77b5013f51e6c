package org.dronewatch.buildings.land;

import java.util.Arrays;

/**
 * The land cover around the origin, in square cells on the plane of the world frame. Immutable, shared by all threads.
 */
public final class LandRaster {
    private final double half;
    private final int side;
    private final double perMetre;
    private final byte[] codes;

    /** How many cells each class has, by its code. */
    private final int[] counts = new int[LandClass.all().size()];

    /**
     * A raster.
     *
     * @param half half the length of a side of the square, m
     * @param side number of cells along a side
     * @param codes codes of the classes, row by row from the south, each from west to east; the array is not copied:
     *     callers must not modify it
     * @throws IllegalArgumentException when there are more or fewer codes than cells, or a code is unknown
     */
    public LandRaster(double half, int side, byte[] codes) {
        if (side < 1 || (long) side * side != codes.length || !(half > 0.0)) {
            throw new IllegalArgumentException(codes.length + " cells for " + side + " rows");
        }
        for (byte code : codes) {
            if (code < 0 || code >= counts.length) {
                throw new IllegalArgumentException("no land cover has the code " + code);
            }
            counts[code]++;
        }
        this.half = half;
        this.side = side;
        this.perMetre = side / (2.0 * half);
        this.codes = codes;
    }

    /** The code of the class at a point, m east and north; that of {@link LandClass#NONE} outside the raster. */
    public int code(double x, double y) {
        double column = Math.floor((x + half) * perMetre);
        double row = Math.floor((y + half) * perMetre);
        return column >= 0.0 && column < side && row >= 0.0 && row < side
                ? codes[(int) row * side + (int) column]
                : LandClass.NONE.code();
    }

    /** The class at a point, m east and north; {@link LandClass#NONE} outside the raster. */
    public LandClass at(double x, double y) {
        return LandClass.all().get(code(x, y));
    }

    /** The areas of all classes, m2, by their codes. */
    public double[] areas() {
        return Arrays.stream(counts)
                .mapToDouble(count -> count / (perMetre * perMetre))
                .toArray();
    }

    /** Whether any cell has a class other than {@link LandClass#NONE}. */
    public boolean isAnywhere() {
        return counts[LandClass.NONE.code()] < codes.length;
    }

    /** Half the length of a side of the square, m. */
    public double half() {
        return half;
    }

    /** The length of a side of a cell, m. */
    public double cell() {
        return 1.0 / perMetre;
    }

    /** The number of cells along a side of the square. */
    public int side() {
        return side;
    }

    /** Runs of adjacent cells of the same class, row by row: for each, its length and the code of its class. */
    public int[] runs() {
        int[] runs = new int[1024];
        int count = 0;
        for (int i = 0; i < codes.length; ) {
            int from = i;
            while (i < codes.length && codes[i] == codes[from]) {
                i++;
            }
            if (count + 2 > runs.length) {
                runs = Arrays.copyOf(runs, 2 * runs.length);
            }
            runs[count++] = i - from;
            runs[count++] = codes[from];
        }
        return Arrays.copyOf(runs, count);
    }

    /**
     * The raster with these {@link #runs}; {@code half} and {@code side} are as for the constructor.
     *
     * @throws IllegalArgumentException when they do not describe a raster of this size
     */
    public static LandRaster ofRuns(double half, int side, int[] runs) {
        if (side < 1 || side > LandPainter.MOST_CELLS) {
            throw new IllegalArgumentException(side + " rows of land cover");
        }
        byte[] codes = new byte[side * side];
        int at = 0;
        for (int i = 0; i + 1 < runs.length; i += 2) {
            boolean isWithin = runs[i] >= 0 && runs[i] <= codes.length - at;
            if (!isWithin || runs[i + 1] != (byte) runs[i + 1]) {
                throw new IllegalArgumentException("a run of " + runs[i] + " cells of " + runs[i + 1]);
            }
            Arrays.fill(codes, at, at + runs[i], (byte) runs[i + 1]);
            at += runs[i];
        }
        return new LandRaster(half, side, codes);
    }
}
