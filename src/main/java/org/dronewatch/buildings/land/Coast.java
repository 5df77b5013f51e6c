package org.dronewatch.buildings.land;

import java.util.Arrays;
import java.util.List;

/**
 * The sea beyond a coastline, which OpenStreetMap draws with the sea on its right. On which side a point lies is
 * decided by the nearest piece of the line; if the nearest point of the line is a corner, by that piece at the corner
 * which is seen the least obliquely from the point, which is right for acute corners, too (V. Chlumsky, Shape
 * Decomposition for Multi-channel Distance Fields, 2015, section 2.4: pseudo-distance and orthogonality). Where the
 * line ends inside the area, the border between both sides is equally far from both ends.
 */
final class Coast {
    private static final int NUMBERS = 4;

    private final double[] pieces;

    /** A coast of lines in the world frame: x and y of each corner in turn. */
    Coast(List<double[]> lines) {
        int count = 0;
        for (double[] line : lines) {
            count += Math.max(0, line.length / 2 - 1);
        }
        double[] all = new double[NUMBERS * count];
        int at = 0;
        for (double[] line : lines) {
            for (int i = 0; i + 3 < line.length; i += 2) {
                // A piece without a length has no sides.
                if (line[i] != line[i + 2] || line[i + 1] != line[i + 3]) {
                    System.arraycopy(line, i, all, at, NUMBERS);
                    at += NUMBERS;
                }
            }
        }
        pieces = Arrays.copyOf(all, at);
    }

    /** Fills the cells whose centres lie in the sea; nothing without a coastline. */
    void paint(LandPainter target, LandClass sea) {
        int[] near = new int[pieces.length / NUMBERS];
        Arrays.setAll(near, i -> i);
        if (near.length > 0) {
            // A power of two, which has quarters of whole cells.
            paint(0, 0, Integer.highestOneBit(2 * target.side() - 1), near, near.length, target, sea);
        }
    }

    /**
     * Fills a square of cells. No line passes through a square whose centre is farther from all of them than its
     * corners: then it lies on one side. Otherwise its quarters are filled, for which only those pieces matter that may
     * be the nearest somewhere in it.
     */
    private void paint(
            int column, int row, int size, int[] pieceNumbers, int count, LandPainter target, LandClass sea) {
        int width = Math.min(size, target.side() - column);
        int height = Math.min(size, target.side() - row);
        if (width <= 0 || height <= 0) {
            return;
        }
        double half = 0.5 * target.cell();
        double x = target.centre(column) + (size - 1) * half;
        double y = target.centre(row) + (size - 1) * half;
        double reach = Math.sqrt(2.0) * size * half;
        int nearest = nearest(x, y, pieceNumbers, count);
        double distance = distance(nearest, x, y);
        if (size == 1 || distance > reach) {
            if (isOnTheRight(nearest, x, y)) {
                for (int i = row; i < row + height; i++) {
                    target.set(i, column, column + width, sea);
                }
            }
            return;
        }
        int[] near = new int[count];
        int kept = 0;
        for (int i = 0; i < count; i++) {
            if (distance(pieceNumbers[i], x, y) <= distance + 2.0 * reach) {
                near[kept++] = pieceNumbers[i];
            }
        }
        int part = size / 2;
        paint(column, row, part, near, kept, target, sea);
        paint(column + part, row, part, near, kept, target, sea);
        paint(column, row + part, part, near, kept, target, sea);
        paint(column + part, row + part, part, near, kept, target, sea);
    }

    /** Whether a point lies in the sea; there must be a coastline. */
    boolean isSea(double x, double y) {
        int[] all = new int[pieces.length / NUMBERS];
        Arrays.setAll(all, i -> i);
        return isOnTheRight(nearest(x, y, all, all.length), x, y);
    }

    private int nearest(double x, double y, int[] numbers, int count) {
        int best = numbers[0];
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double distance = distance(numbers[i], x, y);
            if (distance < least || distance == least && directness(numbers[i], x, y) > directness(best, x, y)) {
                best = numbers[i];
                least = distance;
            }
        }
        return best;
    }

    private double distance(int piece, double x, double y) {
        int at = NUMBERS * piece;
        double dx = pieces[at + 2] - pieces[at];
        double dy = pieces[at + 3] - pieces[at + 1];
        double along = ((x - pieces[at]) * dx + (y - pieces[at + 1]) * dy) / (dx * dx + dy * dy);
        // The distance from a corner is exact, so that both pieces that meet there are at the same distance.
        if (along <= 0.0) {
            return Math.hypot(x - pieces[at], y - pieces[at + 1]);
        }
        return along >= 1.0
                ? Math.hypot(x - pieces[at + 2], y - pieces[at + 3])
                : Math.hypot(x - pieces[at] - along * dx, y - pieces[at + 1] - along * dy);
    }

    /** How far a point lies from the straight line through a piece, m: less the more obliquely the piece is seen. */
    private double directness(int piece, double x, double y) {
        return Math.abs(offset(piece, x, y));
    }

    private boolean isOnTheRight(int piece, double x, double y) {
        return offset(piece, x, y) < 0.0;
    }

    /** The distance from the straight line through a piece, m, positive on its left. */
    private double offset(int piece, double x, double y) {
        int at = NUMBERS * piece;
        double dx = pieces[at + 2] - pieces[at];
        double dy = pieces[at + 3] - pieces[at + 1];
        return (dx * (y - pieces[at + 1]) - dy * (x - pieces[at])) / Math.hypot(dx, dy);
    }
}
