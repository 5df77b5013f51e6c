package org.dronewatch.terrain;

import java.util.Arrays;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import org.dronewatch.parallel.LongTask;
import org.dronewatch.setting.InputException;

/**
 * Covers posts with as few triangles as keep every post within a given vertical error, by greedy insertion (Garland and
 * Heckbert, Fast polygonal approximation of terrains and height fields, CMU-CS-95-181, algorithm III). It begins with
 * two triangles; the post that is furthest from its triangle becomes a corner, until none is further than allowed.
 * Posts at the rims of holes always stay, so that no triangle reaches into a hole.
 *
 * <p>Triangles are chosen by columns and rows, on a flat map. In the world frame, in which maps are curved, the errors
 * are measured again, and the few posts that are too far off there are added.
 */
final class Decimation {
    /**
     * The most triangles that are kept: at a hundred bytes each, with a tree over them, they fill a gigabyte or more.
     */
    private static final int MOST_TRIANGLES = 10_000_000;

    private static final int NONE = -1;
    private static final int PATIENCE = 1 << 12;
    private static final long PRIME = 1_000_003;

    private final Posts posts;
    private final int columns;
    private final double accuracy;
    private final int most;
    private final Triangulation triangulation;
    private final PostFrame.Row frame;
    private final boolean[] isCorner;
    private final WorstFirst worst = new WorstFirst();
    private final double missing;
    private final LongTask task;
    private int[] candidates = new int[1024];
    private double[] errors = new double[1024];
    private int[] seen = new int[1024];
    private int turn;
    private boolean isInWorld;

    private Decimation(Posts posts, double accuracy, int most, LongTask task) {
        this.posts = posts;
        this.columns = posts.columns();
        this.accuracy = accuracy;
        this.most = most;
        this.task = task;
        this.triangulation = new Triangulation(columns, posts.rows());
        this.frame = posts.frame().newRow();
        this.isCorner = new boolean[columns * posts.rows()];
        this.missing = anyHeight();
        int south = (posts.rows() - 1) * columns;
        for (int corner : new int[] {0, columns - 1, south, south + columns - 1}) {
            isCorner[corner] = true;
        }
    }

    /** A height for corners of the rectangle that are in a hole. */
    private double anyHeight() {
        for (int post = 0; post < isCorner.length; post++) {
            if (!posts.isHole(post)) {
                return posts.up(post);
            }
        }
        return 0.0;
    }

    /**
     * The triangles.
     *
     * @param accuracy the greatest vertical error at a post, m; at 0 every post is a corner
     * @throws InputException when that takes more than {@value #MOST_TRIANGLES} triangles
     */
    static PostTriangles of(Posts posts, double accuracy, LongTask task) {
        return of(posts, accuracy, MOST_TRIANGLES, task);
    }

    /**
     * The triangles.
     *
     * @param most how many there may be
     * @param task advances with each post that is kept
     */
    static PostTriangles of(Posts posts, double accuracy, int most, LongTask task) {
        if (accuracy > 0.0) {
            return new Decimation(posts, accuracy, most, task).run();
        }
        checkCount(PostTriangles.countAll(posts), accuracy, most);
        return PostTriangles.all(posts);
    }

    private static void checkCount(int count, double accuracy, int most) {
        if (count > most) {
            throw new InputException(String.format(
                    Locale.ROOT,
                    "an accuracy of %s m needs more than %,d triangles, the maximum: allow a larger error, or choose a"
                            + " smaller radius",
                    accuracy,
                    most));
        }
    }

    private PostTriangles run() {
        keepRims();
        scanAll();
        insertWorst();
        isInWorld = true;
        scanAll();
        insertWorst();
        return triangles();
    }

    /**
     * The posts at holes, in an order without a pattern: row by row, each would become a corner of many thin triangles.
     */
    private void keepRims() {
        int[] rims = new int[64];
        int count = 0;
        for (int post = 0; post < isCorner.length; post++) {
            if (!isCorner[post] && !posts.isHole(post)) {
                long around = posts.around(post);
                if (around >> 32 != (int) around) {
                    rims = count == rims.length ? Arrays.copyOf(rims, 2 * count) : rims;
                    rims[count++] = post;
                }
            }
        }
        // A step that shares no factor with the count visits all of them.
        long step = count % PRIME == 0 ? 1 : PRIME;
        for (long i = 0; i < count; i++) {
            int post = rims[(int) (i * step % count)];
            triangulation.insert(post, triangulation.find(post));
            isCorner[post] = true;
        }
    }

    private void scanAll() {
        for (int t = 0; t < triangulation.count(); t++) {
            scan(t);
        }
    }

    private void insertWorst() {
        int done = 0;
        while (!worst.isEmpty()) {
            task.advance(1);
            if (++done % PATIENCE == 0 && Thread.currentThread().isInterrupted()) {
                throw new CancellationException("interrupted while reading the terrain");
            }
            checkCount(triangulation.count(), accuracy, most);
            int t = worst.worst();
            int post = candidates[t];
            triangulation.insert(post, t);
            isCorner[post] = true;
            turn++;
            TriangleStack touched = triangulation.touched();
            for (int i = 0; i < touched.size(); i++) {
                scan(touched.get(i));
            }
        }
    }

    /** Finds the post that is furthest from a triangle. */
    private void scan(int t) {
        if (t >= candidates.length) {
            int length = Math.max(2 * candidates.length, t + 1);
            candidates = Arrays.copyOf(candidates, length);
            errors = Arrays.copyOf(errors, length);
            seen = Arrays.copyOf(seen, length);
        }
        if (turn > 0 && seen[t] == turn) {
            return;
        }
        seen[t] = turn;
        candidates[t] = NONE;
        errors[t] = 0.0;
        TriangleRows triangle = new TriangleRows(
                columns, triangulation.corner(t, 0), triangulation.corner(t, 1), triangulation.corner(t, 2));
        Plane plane = isInWorld ? planeInWorld(t) : planeOnMap(t);
        for (int row = triangle.first(); row <= triangle.last(); row++) {
            triangle.to(row);
            if (triangle.west() <= triangle.east()) {
                scanRow(t, row, triangle.west(), triangle.east(), plane);
            }
        }
        worst.set(t, errors[t], accuracy);
    }

    private void scanRow(int t, int row, int west, int east, Plane plane) {
        if (isInWorld) {
            frame.to(row);
        }
        int start = row * columns;
        for (int column = west; column <= east; column++) {
            double up = posts.up(start + column);
            double flat;
            if (isInWorld) {
                frame.column(column);
                flat = plane.at(frame.east(up), frame.north(up));
            } else {
                flat = plane.at(column, row);
            }
            // False for holes, which are not numbers.
            if (Math.abs(up - flat) > errors[t] && !isCorner[start + column]) {
                errors[t] = Math.abs(up - flat);
                candidates[t] = start + column;
            }
        }
    }

    private double up(int post) {
        return posts.isHole(post) ? missing : posts.up(post);
    }

    private Plane planeOnMap(int t) {
        double[] corners = new double[9];
        for (int k = 0; k < 3; k++) {
            int post = triangulation.corner(t, k);
            int row = post / columns;
            corners[3 * k] = post % columns;
            corners[3 * k + 1] = row;
            corners[3 * k + 2] = up(post);
        }
        return Plane.through(corners);
    }

    private Plane planeInWorld(int t) {
        double[] corners = new double[9];
        for (int k = 0; k < 3; k++) {
            int post = triangulation.corner(t, k);
            frame.to(post / columns);
            frame.column(post % columns);
            corners[3 * k] = (float) frame.east(up(post));
            corners[3 * k + 1] = (float) frame.north(up(post));
            corners[3 * k + 2] = up(post);
        }
        return Plane.through(corners);
    }

    /** Without the triangles in holes. */
    private PostTriangles triangles() {
        int[] kept = new int[3 * triangulation.count()];
        int count = 0;
        double reached = 0.0;
        for (int t = 0; t < triangulation.count(); t++) {
            if (!isInHole(t)) {
                for (int k = 0; k < 3; k++) {
                    kept[count++] = triangulation.corner(t, k);
                }
                reached = Math.max(reached, errors[t]);
            }
        }
        return new PostTriangles(Arrays.copyOf(kept, count), reached);
    }

    /** Rims are edges of triangles: one whose middle lies in a hole lies there as a whole. */
    private boolean isInHole(int t) {
        int sumX = 0;
        int sumY = 0;
        for (int k = 0; k < 3; k++) {
            int post = triangulation.corner(t, k);
            if (posts.isHole(post)) {
                return true;
            }
            sumX += post % columns;
            sumY += post / columns;
        }
        int square = sumY / 3 * columns + sumX / 3;
        return sumX % 3 >= sumY % 3 ? !posts.hasNorthEast(square) : !posts.hasSouthWest(square);
    }
}
