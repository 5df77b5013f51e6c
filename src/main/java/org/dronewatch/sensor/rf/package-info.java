/** The radio receiver: how strong a drone's and its pilot's emissions arrive, in the open and behind an obstacle. */
package org.dronewatch.sensor.rf;
