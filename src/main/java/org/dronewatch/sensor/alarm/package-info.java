/** False alarms of sensors: how often they are raised, where, and their random draws in a run. */
package org.dronewatch.sensor.alarm;
