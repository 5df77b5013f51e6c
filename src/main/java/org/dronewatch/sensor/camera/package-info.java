/** Cameras for visible light: how much of a drone's picture is enough. */
package org.dronewatch.sensor.camera;
