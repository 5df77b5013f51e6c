/**
 * Radars: the range equation, the detection of echoes in noise and clutter, and their attenuation by rain and
 * obstacles.
 */
package org.dronewatch.sensor.radar;
