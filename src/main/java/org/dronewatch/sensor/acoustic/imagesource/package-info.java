/**
 * The walls that reflect sound specularly, the image sources of a point in them, and the paths from image sources; and
 * what the walls along a path transmit.
 */
package org.dronewatch.sensor.acoustic.imagesource;
