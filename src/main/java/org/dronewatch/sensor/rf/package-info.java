/** Radio receivers: the reception of a drone's and its pilot's emissions, in the open and behind obstacles. */
package org.dronewatch.sensor.rf;
