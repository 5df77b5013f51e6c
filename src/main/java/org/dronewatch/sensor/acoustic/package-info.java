/** Microphones: sound is traced as rays between the drone and the sensor, directly and via reflections. */
package org.dronewatch.sensor.acoustic;
