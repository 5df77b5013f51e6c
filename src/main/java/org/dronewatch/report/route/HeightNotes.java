package org.dronewatch.report.route;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.cell.RouteHeights;
import org.dronewatch.route.RouteSurvey;
import org.dronewatch.route.SectorRoute;

/**
 * Notes on where no routes are searched for although a drone can fly there: close to the ground, below its ceiling, or
 * before it reaches the area.
 *
 * @param inputs inputs of the search
 */
record HeightNotes(RouteInputs inputs) {
    /** Above this height, little on the ground hides a drone that is still outside the area, m. */
    private static final double OPEN_AIR = 150.0;

    /** A route on which the drone is detected with this probability is not weak, whatever is not counted. */
    private static final double DETECTED = 0.95;

    /**
     * Which routes begin so high that sensors may well detect the drone before it reaches the area, which does not
     * count; empty if there are none.
     */
    Optional<String> beginningHigh(RouteSurvey survey) {
        List<SectorRoute> routes = survey.routes().stream()
                .filter(route -> route.inTime(survey.response()) < DETECTED)
                .filter(route -> route.searched().points().get(0).above() > OPEN_AIR)
                .toList();
        return routes.isEmpty() || inputs.launch().isPresent()
                ? Optional.empty()
                : Optional.of("On " + RouteDirections.routes(routes) + ", the drone starts more than "
                        + number(OPEN_AIR) + " m above the ground at the edge of the area. Detections farther out"
                        + " do not count; to count them, try a larger --side.");
    }

    /** Up to which height routes are searched for; empty if that is the drone's ceiling. */
    Optional<String> belowCeiling() {
        return inputs.highest() < inputs.ceiling()
                ? Optional.of("Routes more than " + number(inputs.highest())
                        + " m above the ground were not searched for, although the drone's ceiling is "
                        + number(inputs.ceiling()) + " m; to include them, add higher --heights.")
                : Optional.empty();
    }

    /** How to search for less exposed routes closer to the ground; empty if the search begins as low as by default. */
    Optional<String> closerToTheGround() {
        return inputs.lowest() > RouteHeights.upTo(inputs.ceiling()).get(0)
                ? Optional.of("to look for them less than " + number(inputs.lowest())
                        + " m above the ground, add lower --heights")
                : Optional.empty();
    }
}
