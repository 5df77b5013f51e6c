package org.dronewatch.sensor.optics;

import java.util.function.BooleanSupplier;
import java.util.function.IntPredicate;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.silhouette.SilhouetteMask;
import org.dronewatch.drone.silhouette.SilhouetteTable;
import org.dronewatch.geometry.Position;

/**
 * Bounds on the number of pixels that show a level drone at a position, for one heading ({@link #count}) or for every
 * heading ({@link #mostAround}). The rays of the pixels around the drone are looked up in masks of its silhouette, and
 * in the image of the site. Only rays for which neither gives a certain answer are traced to the drone, and only on
 * request. Reused for many positions. For use by one thread.
 */
public final class PixelBounds {
    /** Number of rays that are traced before bounds that did not suffice are checked again. */
    private static final int TRACED_AT_ONCE = 6;

    /**
     * The sufficient number of pixels that is found exceeds the least sufficient one by at most one part in this
     * number.
     */
    private static final int PRECISION = 16;

    /** Number of pixels that are counted before the count is compared with the sufficient number. */
    private static final int COUNTED_AT_ONCE = 128;

    private final PixelSample pixels;

    /** The mask of the last count; null for none. */
    private SilhouetteMask mask;

    /** Whether the last count ended early. */
    private boolean isCutShort;

    /** Whether the upper bound of the last count includes pixels that the site hides. */
    private boolean countsHidden;

    /** Whether hidden pixels need not be traced, since the drone would certainly be detected if nothing hid it. */
    private boolean skipsHidden;

    private int least;
    private int most;
    private int leastInTheOpen;
    private int mostInTheOpen;

    /** The number of pixels that are expected to show the drone. */
    private int expected;

    PixelBounds(CameraObject camera) {
        this.pixels = new PixelSample(camera);
    }

    /**
     * Sets the position of a drone.
     *
     * @param site the site without drones
     * @param at origin of the drone, m
     * @return false where no bounds are known: close to the camera, and at the near and far planes
     */
    boolean set(Background site, SilhouetteTable table, Position at) {
        return pixels.set(site, table, at);
    }

    /**
     * Whether it is certain that the site hides the drone, whatever its heading, or that the drone lies between the
     * rays of the pixels.
     */
    public boolean isInvisible() {
        return pixels.isInvisible();
    }

    /** An upper bound on the number of pixels that show the drone, whatever its heading. */
    public int mostAround() {
        return pixels.mostAround();
    }

    /**
     * An upper bound on the number of pixels that show the drone, whatever its heading, whatever the site hides, and
     * however many pixels have been examined.
     */
    public int mostInRectangle() {
        return pixels.mostInRectangle();
    }

    /**
     * Examines all pixels around the drone if only a sample of them has been examined, or all of the middle rows if
     * there are too many; the caller then counts again.
     *
     * @return false if that has been done before
     */
    public boolean examineAll() {
        return pixels.examineAll();
    }

    /**
     * Counts the pixels of the drone at a heading.
     *
     * @param heading direction of its nose, clockwise from north, rad
     * @param enough whether a number of pixels is sufficient; if it is, every larger number must be as well. Counting
     *     then stops, and the upper bounds are higher
     */
    public void count(double heading, IntPredicate enough) {
        least = 0;
        leastInTheOpen = 0;
        expected = 0;
        isCutShort = false;
        countsHidden = false;
        mask = pixels.mask(heading);
        if (mask == null) {
            countAround();
            return;
        }
        if (countCertain(findSufficient(enough, PRECISION))) {
            isCutShort = true;
            countAround();
        } else if (pixels.isComplete()) {
            countPossible();
        } else {
            countAround();
        }
    }

    /**
     * A sufficient number of pixels, hardly greater than the least sufficient one: certain pixels are counted only up
     * to this number. The greatest integer if no possible number suffices.
     *
     * @param precision the number may exceed the least sufficient one by one part in this value
     */
    private int findSufficient(IntPredicate enough, int precision) {
        int tooFew = 0;
        int found = Integer.MAX_VALUE;
        int next = mostAround();
        while (next > tooFew) {
            if (enough.test(next)) {
                found = next;
            } else if (found == Integer.MAX_VALUE) {
                return found;
            } else {
                tooFew = next;
            }
            // The geometric mean: a few pixels may suffice, or many thousands.
            next = found - tooFew > 1 + tooFew / precision
                    ? Math.max(tooFew + 1, (int) Math.sqrt((tooFew + 1.0) * found))
                    : tooFew;
        }
        return found;
    }

    /**
     * Counts the pixels that certainly show the drone, up to a sufficient number, and returns whether there are that
     * many.
     */
    private boolean countCertain(int sufficient) {
        int first = 0;
        while (least < sufficient && pixels.has(first)) {
            int last = Math.min(pixels.examined(), first + COUNTED_AT_ONCE);
            least += pixels.countCertain(mask, first, last);
            first = last;
        }
        leastInTheOpen = least;
        return least >= sufficient;
    }

    /** Counts the pixels that may show the drone, and those that would show it if nothing hid it. */
    private void countPossible() {
        most = 0;
        leastInTheOpen = 0;
        mostInTheOpen = 0;
        for (int i = 0; pixels.has(i); i++) {
            byte kind = pixels.kind(mask, i);
            if (kind != SilhouetteMask.OUTSIDE) {
                boolean isHidden = pixels.sight(i) == PixelSample.HIDDEN;
                leastInTheOpen += kind == SilhouetteMask.INSIDE ? 1 : 0;
                mostInTheOpen++;
                most += isHidden ? 0 : 1;
                expected += kind == SilhouetteMask.UNLIKELY || isHidden ? 0 : 1;
            }
        }
    }

    /**
     * Traces pixels that the last count left undecided, until the bounds suffice or are exact: first the pixels that
     * are expected to decide.
     *
     * @param enough the predicate passed to that count
     * @param isSufficient whether the bounds suffice as they are
     * @return false where it is faster to draw a picture of the drone
     */
    boolean refine(DynamicView drawing, Drone drone, IntPredicate enough, BooleanSupplier isSufficient) {
        if (isCutShort || !pixels.isComplete()) {
            return false;
        }
        boolean isExpected = mask == null || enough.test(expected);
        skipsHidden = !countsHidden && enough.test(leastInTheOpen);
        int decisive = mask == null ? Integer.MAX_VALUE : countDecisive(isExpected, enough);
        if (!drawing.beginSingly(drone, Math.min(decisive, countInDoubt()))) {
            return false;
        }
        BooleanSupplier isDecided = () -> enough.test(least) || !enough.test(most);
        if (!trace(drawing, isExpected, isDecided, isSufficient)) {
            trace(drawing, !isExpected, isDecided, isSufficient);
        }
        return true;
    }

    /** The number of traced pixels that decide the outcome if they show what is expected of them. */
    private int countDecisive(boolean isExpected, IntPredicate enough) {
        int needed = findSufficient(enough, Integer.MAX_VALUE);
        if (isExpected) {
            return needed - least;
        }
        return skipsHidden && needed < Integer.MAX_VALUE ? most - needed : Integer.MAX_VALUE;
    }

    /** Traces the pixels that are likely to show the drone, or the others, and returns whether that suffices. */
    private boolean trace(
            DynamicView drawing, boolean isLikely, BooleanSupplier isDecided, BooleanSupplier isSufficient) {
        int left = 0;
        for (int i = 0; pixels.has(i); i++) {
            byte kind = kind(i);
            if (isInDoubt(i, kind) && isLikely == kind > SilhouetteMask.UNLIKELY) {
                trace(drawing, i, kind == SilhouetteMask.INSIDE);
                left--;
                if (left < 0 && isDecided.getAsBoolean()) {
                    if (isSufficient.getAsBoolean()) {
                        return true;
                    }
                    left = TRACED_AT_ONCE;
                }
            }
        }
        return false;
    }

    private byte kind(int pixel) {
        return mask == null ? SilhouetteMask.LIKELY : pixels.kind(mask, pixel);
    }

    private boolean isInDoubt(int pixel, byte kind) {
        byte sight = pixels.sight(pixel);
        return kind == SilhouetteMask.INSIDE
                ? sight == PixelSample.UNCERTAIN
                : kind != SilhouetteMask.OUTSIDE && !(skipsHidden && sight == PixelSample.HIDDEN);
    }

    private int countInDoubt() {
        int inDoubt = 0;
        for (int i = 0; pixels.has(i); i++) {
            inDoubt += isInDoubt(i, kind(i)) ? 1 : 0;
        }
        return inDoubt;
    }

    private void trace(DynamicView drawing, int pixel, boolean isInside) {
        float distance = drawing.distanceSingly(pixels.column(pixel), pixels.row(pixel));
        boolean isHit = distance < Float.POSITIVE_INFINITY;
        boolean isSeen = isHit && distance < pixels.siteDistance(pixel);
        leastInTheOpen += isHit && !isInside ? 1 : 0;
        mostInTheOpen -= isHit ? 0 : 1;
        least += isSeen ? 1 : 0;
        most -= isSeen || !countsHidden && pixels.sight(pixel) == PixelSample.HIDDEN ? 0 : 1;
    }

    /** Sets the upper bounds to the number of pixels around the drone. */
    private void countAround() {
        most = mostAround();
        mostInTheOpen = mostAround();
        countsHidden = true;
    }

    /** A lower bound on the number of pixels that show the drone at the heading that was counted last. */
    public int least() {
        return least;
    }

    /** An upper bound on the number of pixels that show the drone at the heading that was counted last. */
    public int most() {
        return most;
    }

    /**
     * A lower bound on the number of pixels that would show the drone, at the heading that was counted last, if nothing
     * hid it.
     */
    public int leastInTheOpen() {
        return leastInTheOpen;
    }

    /**
     * An upper bound on the number of pixels that would show the drone, at the heading that was counted last, if
     * nothing hid it.
     */
    public int mostInTheOpen() {
        return mostInTheOpen;
    }
}
