/** Cameras for visible light: one ray a pixel, and only the pixels that can show the drone are traced again. */
package org.dronewatch.sensor.camera;
