package org.dronewatch.report.route;

import static org.dronewatch.report.html.ReadableNumbers.number;

import java.util.Optional;
import org.dronewatch.analysis.cell.RouteHeights;

/**
 * Where no routes are searched for, though a drone can fly there: close to the ground, or below its ceiling.
 *
 * @param inputs of the search
 */
record HeightNotes(RouteInputs inputs) {
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
