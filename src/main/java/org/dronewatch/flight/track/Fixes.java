package org.dronewatch.flight.track;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.setting.InputException;

/** Collects the points of a track, in the order of the file, and checks their times. For a single use. */
final class Fixes {
    /** Maximum number of points of a track. */
    static final int MOST = 1_000_000;

    private final String name;
    private final List<Fix> all = new ArrayList<>();
    private int repeated;

    /**
     * A position of the drone as it was recorded.
     *
     * @param line number of the line in the file
     * @param time time on any clock, s; NaN if the file has no times
     * @param height height, m; empty if the file has none
     */
    record Fix(long line, double time, EarthPoint place, OptionalDouble height) {
        boolean isTimed() {
            return !Double.isNaN(time);
        }
    }

    /**
     * The points that were read.
     *
     * @param fixes one or more points; either all of them have a time, in increasing order, or none has
     * @param notes a line for each kind of content that was left out
     */
    record Points(List<Fix> fixes, List<String> notes) {
        Points {
            fixes = List.copyOf(fixes);
            notes = List.copyOf(notes);
        }

        boolean isTimed() {
            return fixes.get(0).isTimed();
        }
    }

    /** A collection without points. */
    Fixes(String name) {
        this.name = name;
    }

    int size() {
        return all.size();
    }

    /** Adds a point; a point with the same time as the one before it is left out. */
    void add(Fix fix) {
        if (!all.isEmpty()) {
            Fix last = all.get(all.size() - 1);
            if (last.isTimed() != fix.isTimed()) {
                throw new InputException(name + ":" + fix.line() + ": "
                        + (fix.isTimed()
                                ? "has a time, but points before it have none"
                                : "has no time, but points before it have one"));
            }
            if (fix.time() < last.time()) {
                throw new InputException(name + ":" + fix.line() + ": is " + (float) (last.time() - fix.time())
                        + " s before the point on line " + last.line() + ": times must increase");
            }
            if (fix.time() == last.time()) {
                repeated++;
                return;
            }
        }
        if (all.size() == MOST) {
            throw new InputException(name + ":" + fix.line() + ": more than " + MOST + " points");
        }
        all.add(fix);
    }

    /**
     * The points.
     *
     * @throws InputException when there are none
     */
    Points points(List<String> notes) {
        if (all.isEmpty()) {
            throw new InputException(name + ": has no points");
        }
        List<String> lines = new ArrayList<>(notes);
        if (repeated > 0) {
            lines.add(repeated + (repeated == 1 ? " point has" : " points have")
                    + " the same time as the one before, and " + (repeated == 1 ? "is" : "are") + " left out");
        }
        return new Points(all, lines);
    }
}
