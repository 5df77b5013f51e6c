package org.dronewatch.route.proof;

import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.IntConsumer;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;
import org.dronewatch.route.SiteRoutes;
import org.dronewatch.route.search.WeakestRoute;

/**
 * Finds the weakest routes of a site, judged by the looks along them. First the looks along each route that the search
 * has found are assessed. Where these looks detect the drone more often than the search expected
 * ({@link SectorRoute#isUnderestimated}), {@link UnforeseenExposure the exposure} found along them is added to that of
 * the search, the search is repeated, and the looks along the new routes are assessed in turn. Where detections come
 * too late, the looks along the routes that are least exposed {@linkplain SiteRoutes#throughout all the way} are
 * assessed, too. From each sector, the weakest route is kept, by the order of {@link RouteSurvey#weakestFirst}; in a
 * tie, the one that was found first. For use by one thread at a time.
 */
public final class RepeatedSearch {
    /** The greatest number of times that the search is repeated. */
    public static final int MOST = 4;

    private final SiteRoutes site;
    private final RouteSurvey survey;
    private final UnaryOperator<SectorRoute> looks;

    /** By sector, in the order of the routes. */
    private final Map<Integer, SectorRoute> kept = new LinkedHashMap<>();

    /** The sectors from which the routes that are least exposed all the way have been searched for. */
    private final Set<Integer> avoided = new HashSet<>();

    /**
     * A search that may be repeated.
     *
     * @param site the search
     * @param survey what the search has found
     * @param looks gives a route together with the exposure to the looks along it, as {@link FlownRoute#exposure} does,
     *     or the same route if its looks cannot be assessed
     */
    public RepeatedSearch(SiteRoutes site, RouteSurvey survey, UnaryOperator<SectorRoute> looks) {
        this.site = site;
        this.survey = survey;
        this.looks = looks;
    }

    /**
     * Assesses the looks along each route that was found, before the search is repeated.
     *
     * @param progress receives 1 after each route
     * @throws java.util.concurrent.CancellationException if {@code looks} throws it; the routes so far are kept
     */
    public void assess(IntConsumer progress) {
        for (SectorRoute route : survey.routes()) {
            kept.put(route.sector(), looks.apply(route));
            progress.accept(1);
        }
    }

    /**
     * Whether there is a sector on whose route detections come too late, and which {@link #avoidLateDetections} has not
     * searched yet.
     */
    public boolean isTooLate() {
        return !detectedTooLate().isEmpty();
    }

    /**
     * Searches again from the sectors on whose routes detections come too late, this time for the routes that are least
     * exposed all the way, and assesses the looks along these routes: on them, a detection in time may be just as
     * likely, but a detection at all, in time or too late, is less likely. The exposure found along the looks is added,
     * and this search, too, is repeated. Sectors that an earlier call has searched in this way are left out. This
     * method has to be called again after the search for detections in time has been {@linkplain #repeat repeated},
     * since other routes may then be kept.
     *
     * @param progress receives 1 after each search, of which there are at most {@link #MOST} + 1
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; the best routes so far are
     *     kept, and so is its interrupt status
     */
    public void avoidLateDetections(IntConsumer progress) {
        UnforeseenExposure unforeseen = UnforeseenExposure.none(site.grid());
        Set<Integer> sectors = detectedTooLate().keySet();
        avoided.addAll(sectors);
        for (int search = 0; search <= MOST && !sectors.isEmpty(); search++) {
            Map<Integer, WeakestRoute> before = new LinkedHashMap<>();
            kept.forEach((sector, route) -> before.put(sector, route.route()));
            Set<Integer> latest = new LinkedHashSet<>();
            for (Map.Entry<Integer, List<WeakestRoute>> found :
                    site.throughout(before, sectors, unforeseen).entrySet()) {
                for (WeakestRoute route : found.getValue()) {
                    SectorRoute other = tryRoute(found.getKey(), route);
                    if (other.isUnderestimatedThroughout()) {
                        unforeseen = unforeseen.with(other, site.modes());
                        latest.add(found.getKey());
                    }
                }
            }
            latest.removeIf(sector -> !kept.get(sector).isDetectedTooLate(survey.response()));
            sectors = latest;
            progress.accept(1);
        }
    }

    /** Assesses the looks along a route that was found later, and keeps it if it is weaker. */
    private SectorRoute tryRoute(int sector, WeakestRoute found) {
        SectorRoute other = looks.apply(site.describe(sector, found));
        if (isKept(other)) {
            kept.put(sector, other);
        }
        return other;
    }

    /** Whether the looks along any of the kept routes detect the drone more often than the search expected. */
    public boolean isNeeded() {
        return !underestimated().isEmpty();
    }

    private Map<Integer, SectorRoute> underestimated() {
        return keptThat(route -> route.isUnderestimated(survey.response()));
    }

    private Map<Integer, SectorRoute> detectedTooLate() {
        return keptThat(route -> !avoided.contains(route.sector()) && route.isDetectedTooLate(survey.response()));
    }

    private Map<Integer, SectorRoute> keptThat(Predicate<SectorRoute> isMeant) {
        Map<Integer, SectorRoute> routes = new LinkedHashMap<>();
        kept.forEach((sector, route) -> {
            if (isMeant.test(route)) {
                routes.put(sector, route);
            }
        });
        return routes;
    }

    /**
     * Repeats the search until its expectations agree with the looks, or it finds the same routes again, but at most
     * {@link #MOST} times.
     *
     * @param progress receives 1 after each repetition
     * @throws java.util.concurrent.CancellationException when this thread is interrupted; the best routes so far are
     *     kept, and so is its interrupt status
     */
    public void repeat(IntConsumer progress) {
        UnforeseenExposure unforeseen = UnforeseenExposure.none(site.grid());
        Map<Integer, SectorRoute> latest = underestimated();
        for (int search = 0; search < MOST && !latest.isEmpty(); search++) {
            Map<Integer, WeakestRoute> before = new LinkedHashMap<>();
            for (SectorRoute route : latest.values()) {
                unforeseen = unforeseen.with(route, site.modes());
                before.put(route.sector(), route.route());
            }
            latest = new LinkedHashMap<>();
            for (Map.Entry<Integer, WeakestRoute> found :
                    site.past(before, unforeseen).entrySet()) {
                int sector = found.getKey();
                if (found.getValue().path().equals(before.get(sector).path())) {
                    continue;
                }
                SectorRoute other = tryRoute(sector, found.getValue());
                if (other.isUnderestimated(survey.response())) {
                    latest.put(sector, other);
                }
            }
            progress.accept(1);
        }
    }

    /** Whether a route replaces the one that has been kept from its sector. */
    private boolean isKept(SectorRoute other) {
        return survey.weakestFirst().compare(other, kept.get(other.sector())) < 0;
    }

    /**
     * A survey of the routes that have been kept. It is complete if the survey of the search is complete and a route
     * has been kept for each of its sectors.
     */
    public RouteSurvey survey() {
        List<SectorRoute> routes = List.copyOf(kept.values());
        return survey.with(routes, routes.size() == survey.routes().size());
    }
}
