/** The walls that reflect sound specularly: chains of them as seen from a point, and the paths over a chain. */
package org.dronewatch.sensor.acoustic.mirror;
