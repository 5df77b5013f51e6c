/** The geometry of diffraction: the shortest path around obstacles, and the edges near a line of sight. */
package org.dronewatch.sensor.acoustic.edge;
