package org.dronewatch.route;

import java.math.BigDecimal;
import java.math.RoundingMode;
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
 * The weakest route of a site from each sector or, after an interruption, from each sector that was completed.
 *
 * @param routes the routes in the order of their sectors; sectors from which no route leads are left out
 * @param modes modes in which the drone flies, in the order of their numbers
 * @param target where the routes lead: the centre of the protected zone or, without one, the mean position of the
 *     sensors, m
 * @param response the time that a response takes, s; 0 if none is required
 * @param isComplete whether all sectors were searched
 */
public record RouteSurvey(
        List<SectorRoute> routes, List<RouteMode> modes, Position target, double response, boolean isComplete) {
    /** A probability below this is printed as less than this, percent. */
    private static final double LEAST_PERCENT = 0.1;

    /** A probability below this is printed in tenths, percent. */
    private static final double FINE_PERCENT = 10.0;

    /** An exposure below this is printed as less than this. */
    private static final double LEAST_EXPOSURE = 0.001;

    /** An exposure below this is printed in thousandths, and from there on in hundredths. */
    private static final double FINE_EXPOSURE = 1.0;

    /** A time below this is printed in tenths, s. */
    private static final double FINE_SECONDS = 100.0;

    /** Copies the lists. */
    public RouteSurvey {
        routes = List.copyOf(routes);
        modes = List.copyOf(modes);
    }

    /**
     * The routes from all sectors.
     *
     * @param site the routes of the site
     * @param response the time that a response takes, s; 0 if none is required
     * @param searched receives the number of each sector that was searched
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
     * A survey like this one, but with its routes as flown.
     *
     * @param flown the routes as flown: all routes of this survey, or some of them
     * @param isWhole whether these are all of the routes
     */
    public RouteSurvey with(List<SectorRoute> flown, boolean isWhole) {
        return new RouteSurvey(flown, modes, target, response, isComplete && isWhole);
    }

    /** Whether the probability of an alert in time is known for any route. */
    public boolean isAlertKnown() {
        return routes.stream().anyMatch(route -> route.alertInTime().isPresent());
    }

    /**
     * The weakest of all routes: the first in the order of {@link #weakestFirst}. Routes that end where they begin do
     * not count; empty if there are no others.
     */
    public Optional<SectorRoute> weakest() {
        return routes.stream().filter(one -> one.route().seconds() > 0.0).min(weakestFirst());
    }

    /**
     * The order from the weakest route to the strongest: first the one with the least probability of an alert in time,
     * where it is known; in a tie, or if it is not known, the one with the least probability of a timely detection,
     * then of any detection along the whole route, then the least exposure that counts in the search, then the shortest
     * time, then the first sector clockwise from north. Figures that look the same in the tables tie: probabilities to
     * a tenth of a percentage point below 10 %, and to a whole one from there on; exposures to a thousandth below 1,
     * and to a hundredth from there on; times to a tenth of a second below 100 s, and to a second from there on.
     * Probabilities below 0.1 % and exposures below 0.001 tie with 0. Without these ties, a route on which the drone is
     * certain to be detected, if only slightly too late, might count as weaker than one on which it is hardly ever
     * detected at all.
     */
    public Comparator<SectorRoute> weakestFirst() {
        return Comparator.comparingDouble(
                        (SectorRoute one) -> probability(one.alertInTime().orElse(one.inTime(response))))
                .thenComparingDouble(one -> probability(one.inTime(response)))
                .thenComparingDouble(one -> probability(one.detection()))
                .thenComparingDouble(one -> exposure(one.route().exposure()))
                .thenComparingDouble(one -> seconds(one.route().seconds()))
                .thenComparingInt(SectorRoute::sector);
    }

    /** A probability as precisely as tables print it, percent. */
    private static double probability(double value) {
        double percent = 100.0 * value;
        return percent < LEAST_PERCENT ? 0.0 : rounded(percent, percent < FINE_PERCENT ? 1 : 0);
    }

    /** An exposure as precisely as tables print it. */
    private static double exposure(double value) {
        return value < LEAST_EXPOSURE ? 0.0 : rounded(value, value < FINE_EXPOSURE ? 3 : 2);
    }

    /** A time as precisely as tables print it, s. */
    private static double seconds(double value) {
        double tenths = rounded(value, 1);
        return tenths < FINE_SECONDS ? tenths : rounded(tenths, 0);
    }

    /** Rounded as text is. */
    private static double rounded(double value, int places) {
        return BigDecimal.valueOf(value).setScale(places, RoundingMode.HALF_UP).doubleValue();
    }
}
