package org.dronewatch.placement.site;

import java.util.ArrayList;
import java.util.List;

/**
 * What a time limit has stopped.
 *
 * @param seconds the time limit, s
 * @param gap the gap at which the search was to end, as a fraction of the layout's value, 0 to 1
 * @param gapReached whether the layout for the whole budget has reached the gap
 * @param cheaper whether the search for cheaper layouts was stopped, or had no time left to begin
 * @param leftOut what was still incomplete {@link org.dronewatch.placement.SearchEnd#FOLLOW_UP} seconds after the time
 *     limit
 */
public record TimeStop(double seconds, double gap, boolean gapReached, boolean cheaper, List<LeftOut> leftOut) {
    /** Copies the list. */
    public TimeStop {
        leftOut = List.copyOf(leftOut);
    }

    /** A stop that affected nothing but the search. */
    public TimeStop(double seconds, double gap, boolean gapReached, boolean cheaper) {
        this(seconds, gap, gapReached, cheaper, List.of());
    }

    /** This stop, with one more part that was not complete. */
    TimeStop with(LeftOut part) {
        List<LeftOut> all = new ArrayList<>(leftOut);
        all.add(part);
        return new TimeStop(seconds, gap, gapReached, cheaper, all);
    }
}
