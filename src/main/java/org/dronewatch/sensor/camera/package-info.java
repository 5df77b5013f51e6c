/** Cameras for visible light, and how much of a drone's image is enough for a detection. */
package org.dronewatch.sensor.camera;
