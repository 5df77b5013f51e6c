/**
 * The search for the route on which a drone is least exposed in any field of exposure, with a lower bound on its
 * exposure. The search knows about grids, legs and rates, but not about scenes, sensors or detection fields.
 */
package org.dronewatch.route.search;
