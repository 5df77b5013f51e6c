/** The spectral lines of a drone at the microphone, and the signal-to-noise ratio of each within its line width. */
package org.dronewatch.sensor.acoustic.tone;
