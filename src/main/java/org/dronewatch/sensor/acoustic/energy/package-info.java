/** The energy model: exact paths, and energy carried by rays, in octave bands. */
package org.dronewatch.sensor.acoustic.energy;
