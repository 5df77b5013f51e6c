/** Microphones: sound is traced as rays from the drone, by reflections, to the sensor. */
package org.dronewatch.sensor.acoustic;
