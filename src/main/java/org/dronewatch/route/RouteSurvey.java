package org.dronewatch.route;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.IntConsumer;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.route.search.RouteMode;
import org.dronewatch.route.search.WeakestRoute;

/**
 * The weakest route of a site from each sector; or, after an interruption, from those sectors that were completed.
 *
 * @param routes the routes in the order of their sectors; sectors from which no route leads are left out
 * @param modes modes in which the drone flies, in the order of their numbers
 * @param target where the routes lead: the middle of the protected zone or, without one, the mean position of the
 *     sensors, m
 * @param response the time that a response takes, s; 0 if none is required
 * @param isComplete whether all sectors were searched
 */
public record RouteSurvey(
        List<SectorRoute> routes, List<RouteMode> modes, Position target, double response, boolean isComplete) {
    /** What is below this is printed as less than this, percent. */
    private static final double LEAST_PERCENT = 0.1;

    /** What is below this is printed in tenths, percent. */
    private static final double FINE_PERCENT = 10.0;

    private static final double TENTHS = 10.0;

    /** Copies the lists. */
    public RouteSurvey {
        routes = List.copyOf(routes);
        modes = List.copyOf(modes);
    }

    /**
     * The routes from all sectors.
     *
     * @param response the time that a response takes, s; 0 if none is required
     * @param searched receives each sector that was searched
     * @param stopped called if this thread has been interrupted and at least one sector is complete; it should clear
     *     the interrupt status
     * @throws CancellationException when this thread is interrupted before any sector is complete
     */
    public static RouteSurvey of(SiteRoutes site, double response, IntConsumer searched, Runnable stopped) {
        List<SectorRoute> routes = new ArrayList<>();
        for (int sector = 0; sector < SiteRoutes.SECTORS; sector++) {
            int from = sector;
            try {
                Workers.checkInterrupted();
                site.from(sector).map(route -> site.describe(from, route)).ifPresent(routes::add);
            } catch (CancellationException interrupted) {
                if (sector == 0) {
                    throw interrupted;
                }
                stopped.run();
                return new RouteSurvey(routes, site.modes(), site.target(), response, false);
            }
            searched.accept(sector);
        }
        List<WeakestRoute> joined =
                site.joined(routes.stream().map(SectorRoute::route).toList());
        for (int i = 0; i < joined.size(); i++) {
            if (!joined.get(i).equals(routes.get(i).route())) {
                routes.set(i, site.describe(routes.get(i).sector(), joined.get(i)));
            }
        }
        return new RouteSurvey(routes, site.modes(), site.target(), response, true);
    }

    /**
     * The same routes, or some of them, once they have been flown.
     *
     * @param isWhole whether these are all of the routes
     */
    public RouteSurvey with(List<SectorRoute> flown, boolean isWhole) {
        return new RouteSurvey(flown, modes, target, response, isComplete && isWhole);
    }

    /**
     * The weakest of all routes: the one with the least probability of a timely detection; in a tie, the one with the
     * least probability of any detection along the whole route, then the least exposure that counts in the search, then
     * the shortest time, then the first sector clockwise from the north. Probabilities tie if they are equal as tables
     * print them: to a tenth of a percentage point below 10 %, and to a whole one from there on; anything below 0.1 %
     * ties with 0. Otherwise a route on which the drone is surely detected, if only slightly too late, might count as
     * weaker than one on which it is hardly ever detected at all. Routes that end where they begin do not count; empty
     * if there are no others.
     */
    public Optional<SectorRoute> weakest() {
        return routes.stream()
                .filter(one -> one.route().seconds() > 0.0)
                .min(Comparator.comparingDouble((SectorRoute one) -> printed(one.inTime(response)))
                        .thenComparingDouble(one -> printed(one.detection()))
                        .thenComparingDouble(one -> one.route().exposure())
                        .thenComparingDouble(one -> one.route().seconds())
                        .thenComparingInt(SectorRoute::sector));
    }

    /** A probability as precisely as tables print it, percent. */
    private static double printed(double probability) {
        double percent = 100.0 * probability;
        if (percent < LEAST_PERCENT) {
            return 0.0;
        }
        return percent < FINE_PERCENT ? Math.rint(TENTHS * percent) / TENTHS : Math.rint(percent);
    }
}
