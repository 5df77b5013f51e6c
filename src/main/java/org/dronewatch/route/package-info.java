/**
 * The weakest routes of a site: how exposed a drone is follows from a detection field and from every look along a
 * route, and so does whether it is detected in time.
 */
package org.dronewatch.route;
