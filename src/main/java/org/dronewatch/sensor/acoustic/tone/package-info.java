/** The tones of a drone at the microphone, and the signal-to-noise ratio of each within its width. */
package org.dronewatch.sensor.acoustic.tone;
