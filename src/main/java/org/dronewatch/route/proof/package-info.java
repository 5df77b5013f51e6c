/**
 * Whether the search is right: routes as scenes that can be run, how often runs of these scenes detect the drone, and
 * what lies between the centres of the cells of the search.
 */
package org.dronewatch.route.proof;
