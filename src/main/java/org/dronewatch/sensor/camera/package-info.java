/** Cameras for visible light, and their detection functions. */
package org.dronewatch.sensor.camera;
