/** What all kinds of sensors share: settings that create sensors, samples, observations and detections. */
package org.dronewatch.sensor;
