/** Microphones: sound is traced as rays from the drone to the sensor, via reflections. */
package org.dronewatch.sensor.acoustic;
