/**
 * The common parts of all cameras: pictures of a site with drones, with one ray per pixel, of which only those that can
 * show a drone are traced again.
 */
package org.dronewatch.sensor.optics;
