/**
 * The weakest routes of a site: how exposed a drone is along them, and whether it is detected in time, first estimated
 * from a detection field and then from every look along the route.
 */
package org.dronewatch.route;
