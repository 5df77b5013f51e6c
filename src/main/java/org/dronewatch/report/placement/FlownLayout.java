package org.dronewatch.report.placement;

import org.dronewatch.report.route.RouteInputs;
import org.dronewatch.report.route.RouteResults;

/**
 * The weakest routes past a layout, searched for and flown as the command {@code route} does.
 *
 * @param inputs of the search: the scene with the layout's sensors
 * @param results the routes from all directions, with every look along them
 */
public record FlownLayout(RouteInputs inputs, RouteResults results) {}
