/**
 * Whether the search is right: routes as scenes that can be run, how often runs of these scenes detect the drone, and
 * whether the sensors detect it between the cell centres, where the search did not look.
 */
package org.dronewatch.route.proof;
