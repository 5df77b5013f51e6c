/** The lines of a drone as they are heard, and how far each is above the noise in a band of its own width. */
package org.dronewatch.sensor.acoustic.tone;
