/** Acoustic quantities such as levels, octave bands and tones; the properties of the air; and the sound of drones. */
package org.dronewatch.sound;
