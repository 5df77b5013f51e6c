/**
 * The walls that reflect sound specularly, the image sources of a point in these walls, the paths constructed from
 * image sources, and the transmission of sound through the walls along a path.
 */
package org.dronewatch.sensor.acoustic.imagesource;
