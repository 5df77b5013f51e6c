/**
 * The search for the route on which a drone is least exposed in any field of exposure, with a lower bound: it knows
 * grids, legs and rates, but no scenes, sensors or detection fields.
 */
package org.dronewatch.route.search;
