package org.dronewatch.route.search;

import java.util.BitSet;
import java.util.List;
import java.util.Optional;
import java.util.function.DoubleFunction;
import org.dronewatch.geometry.Position;

/**
 * The weakest route of a drone that can fly under power only for a limited time. It is found by means of a price of
 * time, a Lagrange multiplier, which is raised until the route is short enough and then refined by bisection. For every
 * price, the least sum of exposure and priced time, less the price of the longest time allowed, is a lower bound on the
 * exposure along all routes that are short enough (the dual bound). Of several routes with the same sum, those between
 * the shortest and the least exposed are not found, so a gap may remain. Where the limit hardly allows a detour, the
 * price would have to be very high, and {@link CorridorBound} is the better bound.
 */
public final class EnduranceLimit {
    /** The exposure for which the whole time counts at the first price. */
    private static final double FIRST = 0.1;

    private static final double FACTOR = 4.0;
    private static final int MOST_RAISES = 14;
    private static final int BISECTIONS = 8;

    private final List<RouteMode> modes;
    private final double seconds;
    private final DoubleFunction<WeakestRoutes> search;

    /** The greatest of the dual bounds so far. */
    private double lower;

    /**
     * A limit.
     *
     * @param seconds longest flight under power, above 0, s
     * @param search gives the weakest routes for a price of time, 1/s
     */
    public EnduranceLimit(List<RouteMode> modes, double seconds, DoubleFunction<WeakestRoutes> search) {
        this.modes = List.copyOf(modes);
        this.seconds = seconds;
        this.search = search;
    }

    /** Whether a route is short enough. */
    public boolean allows(WeakestRoute route) {
        return powered(route.path()) <= seconds;
    }

    private double powered(RoutePath path) {
        double sum = 0.0;
        for (int leg = 0; leg < path.modes().size(); leg++) {
            RouteMode mode = modes.get(path.modes().get(leg));
            if (!mode.isGlide()) {
                Position from = path.points().get(leg);
                Position to = path.points().get(leg + 1);
                sum += mode.time(Math.hypot(to.x() - from.x(), to.y() - from.y()), to.z() - from.z());
            }
        }
        return sum;
    }

    /**
     * The weakest route that is short enough; empty if there is none.
     *
     * @param unlimited the weakest route without the limit
     */
    public Optional<WeakestRoute> from(BitSet starts, WeakestRoute unlimited) {
        lower = unlimited.lower();
        double low = FIRST / (FACTOR * seconds);
        double high = FIRST / seconds;
        WeakestRoutes first = search.apply(high);
        if (isBounded()) {
            lower = Math.max(lower, first.within(starts, seconds));
        }
        Optional<WeakestRoute> best = at(first, high, starts);
        for (int raise = 0; best.isEmpty() && raise < MOST_RAISES; raise++) {
            low = high;
            high *= FACTOR;
            best = at(search.apply(high), high, starts);
        }
        for (int i = 0; best.isPresent() && i < BISECTIONS; i++) {
            double middle = Math.sqrt(low * high);
            Optional<WeakestRoute> other = at(search.apply(middle), middle, starts);
            if (other.isEmpty()) {
                low = middle;
            } else {
                high = middle;
                best = other.get().exposure() < best.get().exposure() ? other : best;
            }
        }
        return best.map(route ->
                new WeakestRoute(route.path(), route.exposure(), Math.min(lower, route.exposure()), route.seconds()));
    }

    /** The weakest route at a price, if it is short enough. */
    private Optional<WeakestRoute> at(WeakestRoutes routes, double price, BitSet starts) {
        if (isBounded()) {
            lower = Math.max(lower, routes.priced(starts) - price * seconds);
        }
        return routes.from(starts).filter(this::allows);
    }

    /**
     * Whether the limit bounds the time of the whole flight: what is flown without power takes time as well, which a
     * limit on powered flight does not bound.
     */
    private boolean isBounded() {
        return modes.stream().noneMatch(RouteMode::isGlide);
    }
}
