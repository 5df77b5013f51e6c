/** Cameras that see heat. */
package org.dronewatch.sensor.thermal;
