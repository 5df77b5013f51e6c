/**
 * The common parts of all cameras: pictures of a site with drones, traced with one ray per pixel. For each new picture,
 * only pixels that can show a drone are traced again.
 */
package org.dronewatch.sensor.optics;
