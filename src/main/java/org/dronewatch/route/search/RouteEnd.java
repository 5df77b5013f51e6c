package org.dronewatch.route.search;

import java.util.OptionalDouble;
import org.dronewatch.geometry.Position;

/** Where on a straight leg a route reaches its end. Not thread-safe. */
@FunctionalInterface
public interface RouteEnd {
    /** A route ends only at a node, not on a leg between nodes. */
    RouteEnd AT_NODE = (from, to) -> OptionalDouble.empty();

    /**
     * Where a leg first arrives, such as at the edge of a zone.
     *
     * @return the fraction of the leg before the arrival, 0 if the leg begins there; empty if the leg does not arrive
     *     before its end
     */
    OptionalDouble entry(Position from, Position to);
}
