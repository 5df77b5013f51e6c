/** The geometry of diffraction: the shortest way round obstacles, and the edges near a line of sight. */
package org.dronewatch.sensor.acoustic.edge;
