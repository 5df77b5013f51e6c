/** False alarms of sensors: their rates, their places, and their random draws in a run. */
package org.dronewatch.sensor.alarm;
