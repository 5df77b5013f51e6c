package org.dronewatch.report.coverage;

import java.util.Optional;
import org.dronewatch.geo.Origin;

/**
 * The inputs of a coverage, as its files state them.
 *
 * @param scene name of the scene
 * @param drone name of the drone
 * @param heading which heading of the drone counts: {@code worst}, {@code best} or {@code inbound}
 * @param covered the probability with which a sensor must detect the drone to cover a cell
 * @param origin geographic position of the scene's origin, if it is known
 */
public record CoverageInputs(String scene, String drone, String heading, double covered, Optional<Origin> origin) {}
