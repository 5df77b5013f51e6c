/**
 * Pictures of a site with drones in it: one ray a pixel, and only the pixels that can show a drone are traced again.
 * What cameras of every kind have in common.
 */
package org.dronewatch.sensor.optics;
