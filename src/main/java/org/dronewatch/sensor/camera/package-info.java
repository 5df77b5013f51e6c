/** Cameras for visible light, and how much of a drone's picture is enough for a detection. */
package org.dronewatch.sensor.camera;
