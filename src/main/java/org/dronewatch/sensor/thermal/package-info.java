/** Thermal cameras. */
package org.dronewatch.sensor.thermal;
