package org.dronewatch.report.route;

import java.util.Optional;
import org.dronewatch.route.SectorRoute;

/**
 * Why the search misjudges the probability that a drone is detected on a route. A third probability lies between that
 * of the search and that of the flight: the one that would result if looks were taken at any moment, as the search
 * assumes. The cells account for its difference from the search, the timing of the looks for its difference from the
 * flight.
 */
enum Misjudgement {
    /** The search assesses each cell only at its centre. */
    CELLS,

    /**
     * A slow sensor may look before the drone comes into sight, or after it has gone: fewer flights are detected than
     * would be by looks at any moment, never more.
     */
    SCANS,

    /** Both contribute much. */
    BOTH;

    /**
     * Why the search misjudges the detections that count: those that are early enough for a response, if one is
     * required. Where a detection would come too late, the search only looks for the fastest route.
     *
     * @param response time that the response takes, s; 0 if none is required
     * @return empty if the probabilities differ by 20 percentage points at most, or if the looks along the route have
     *     not been assessed
     */
    static Optional<Misjudgement> inTime(SectorRoute route, double response) {
        return route.flown()
                .flatMap(looks -> of(
                        route.route().detection(),
                        looks.detectionByFastLooks(route.counted(response)),
                        route.inTime(response)));
    }

    /**
     * Why the search misjudges the detections that come too late for a response, if it misjudges no others.
     *
     * @param response time that the response takes, s; 0 if none is required, so that no detection comes too late
     * @return empty if the search misjudges detections {@linkplain #inTime in time}, or if the probabilities of any
     *     detection differ by 20 percentage points at most
     */
    static Optional<Misjudgement> tooLate(SectorRoute route, double response) {
        return response == 0.0 || inTime(route, response).isPresent()
                ? Optional.empty()
                : route.flown()
                        .flatMap(looks -> of(
                                route.searched().detection(),
                                looks.detectionByFastLooks(Double.POSITIVE_INFINITY),
                                route.detection()));
    }

    /**
     * The cause of the difference between two probabilities of a detection.
     *
     * @param searched the probability according to the search, 0 to 1
     * @param byFastLooks the probability if every sensor looked all the time where the drone flies, 0 to 1
     * @param flown the probability as flown, 0 to 1
     * @return empty if they differ by 20 percentage points at most
     */
    static Optional<Misjudgement> of(double searched, double byFastLooks, double flown) {
        double difference = flown - searched;
        if (Math.abs(difference) <= SectorRoute.MISJUDGED) {
            return Optional.empty();
        }
        if (!isMuch(flown - byFastLooks, difference)) {
            return Optional.of(CELLS);
        }
        return Optional.of(isMuch(byFastLooks - searched, difference) ? BOTH : SCANS);
    }

    /** Whether a step has the sign of the sum of all steps, and exceeds half of the misjudgement that is tolerated. */
    private static boolean isMuch(double step, double all) {
        return Math.signum(all) * step > 0.5 * SectorRoute.MISJUDGED;
    }

    /** Whether smaller cells may help. */
    boolean isForCells() {
        return this != SCANS;
    }

    /** Whether it matters when a slow sensor looks. */
    boolean isForScans() {
        return this != CELLS;
    }
}
