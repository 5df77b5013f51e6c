package org.dronewatch.placement.site;

import java.util.OptionalDouble;

/**
 * What is covered of a protected zone whose cells have a weight, each cell counting once on each heading.
 *
 * @param zone name of the zone; empty for all cells that are in none of the zones with weights
 * @param weight weight of each cell of the zone
 * @param cells number of cells of the zone that count, over all heights
 * @param layout fraction of the zone that the layout covers
 * @param present fraction of the zone that the scene's own sensors cover; empty if it is not known
 */
public record ZoneCoverage(String zone, double weight, int cells, double layout, OptionalDouble present) {}
