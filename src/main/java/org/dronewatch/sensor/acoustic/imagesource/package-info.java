/**
 * The walls that reflect sound specularly, the image sources of a point in them, and the paths from image sources; and
 * what walls on the way of a path transmit.
 */
package org.dronewatch.sensor.acoustic.imagesource;
