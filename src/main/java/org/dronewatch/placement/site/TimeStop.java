package org.dronewatch.placement.site;

/**
 * What a time limit has stopped.
 *
 * @param seconds the time limit, s
 * @param gap the gap to which layouts were sought, as a fraction of their value, 0 to 1
 * @param gapReached whether the layout for the whole budget has reached it: then only the search for cheaper layouts
 *     was stopped
 * @param cheaper whether the search for cheaper layouts was stopped, or had no time left to begin
 */
public record TimeStop(double seconds, double gap, boolean gapReached, boolean cheaper) {}
