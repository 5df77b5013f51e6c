/** Microphones: sound traced as rays from the drone over reflections to the sensor. */
package org.dronewatch.sensor.acoustic;
