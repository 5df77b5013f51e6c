package org.dronewatch.route.search;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/** Where on a straight leg a route reaches its end. One thread at a time. */
@FunctionalInterface
public interface RouteEnd {
    /** A route ends at a post, not on the way to it. */
    RouteEnd AT_POST = (from, to) -> OptionalDouble.empty();

    /**
     * Where a leg first arrives, such as on the edge of a zone.
     *
     * @return fraction of the leg, 0 when it begins there; empty if it does not arrive before its end
     */
    OptionalDouble entry(Position from, Position to);
}
